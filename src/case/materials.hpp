// Materials and contact pairs of a case: the shipped library, extended by the case.
#pragma once
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "case/reader.hpp"
#include "pmr/state/case.hpp"

namespace pmr::casefile {

class MaterialBook {
 public:
  enum class Role : unsigned { particle = 1, surface = 2, lining = 4 };

  // Reads [materials] and [contacts] of the case.
  MaterialBook(Reading& reading, Table& root, std::vector<Provenance>& provenance);

  // The material named by a key of a table; told at `finish` what its role lacks.
  std::uint32_t use(Table& table, const std::string& key, Role role);
  bool empty() const { return materials_.list.empty(); }
  const Material& operator[](std::uint32_t index) const { return materials_.list[index]; }

  // Checks that each material holds what its roles and the models want, and that every pair that
  // can meet has its contact parameters.
  Materials finish(const Models& models);

 private:
  struct Use {
    unsigned roles = 0;
    Place place;  // of the first use
  };
  std::uint32_t load(const std::string& name);
  void check(std::uint32_t index, const Models& models);
  void add_contact(const std::string& key, const Node& node);
  PairContact read_contact(const std::string& key);
  void set_pair(std::uint32_t i, std::uint32_t j);
  std::vector<std::string> names() const;

  Reading& reading_;
  std::vector<Provenance>& provenance_;
  std::map<std::string, Node> nodes_;     // by name
  std::map<std::string, Node> contacts_;  // by "A|B", A <= B
  std::set<std::string> unread_pairs_;    // of the case
  std::map<std::string, std::uint32_t> loaded_;
  std::vector<Use> uses_;
  Materials materials_;
};

// Reads one material; keys that are not given leave NaN behind. Records every figure.
Material read_material(Reading& reading, const Node& node, const std::string& name);

}  // namespace pmr::casefile
