// HDF5 behind one value: the only place that knows the library is hdf5.cpp. A dataset here is a
// table of numbers (rows x width, one-dimensional when width is 1) with a `unit`, or a list of
// texts. A file that is not what was wanted is a CaseError that names file, object and HDF5's own
// reason; what cannot be written is a StorageError.
#pragma once
#include <array>
#include <concepts>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "pmr/base/vec3.hpp"

namespace pmr::io {

enum class Number : std::uint8_t { float32, float64, uint8, uint32, uint64 };

// The number a C++ type is made of, and how many of them.
template <class T>
constexpr Number number_of() {
  if constexpr (std::is_same_v<T, double> || std::is_same_v<T, Vec3>) return Number::float64;
  if constexpr (std::is_same_v<T, float>) return Number::float32;
  if constexpr (std::is_same_v<T, std::uint8_t>) return Number::uint8;
  if constexpr (std::is_same_v<T, std::uint32_t>) return Number::uint32;
  if constexpr (std::is_same_v<T, std::uint64_t>) return Number::uint64;
}
template <class T>
constexpr std::size_t width_of() {
  return std::is_same_v<T, Vec3> ? 3 : 1;
}

// checked: chunks with a Fletcher-32 sum. deflated: that, shuffled and deflated. extendible:
// deflated chunks of which more may follow.
enum class Packing : std::uint8_t { checked, deflated, extendible };

struct Storage {
  std::string unit;  // "K", "m s-1", "1"
  Number number;     // in the file; converted from memory where it differs
  Packing packing;
};

struct Shape {
  std::size_t rows = 0;
  std::size_t width = 1;
};

class H5File {
 public:
  static H5File create(const std::filesystem::path& path);  // whatever stood there goes
  static H5File open(const std::filesystem::path& path);    // to read
  static H5File modify(const std::filesystem::path& path);  // to read and write
  H5File(H5File&& other) noexcept;
  H5File(const H5File&) = delete;
  H5File& operator=(const H5File&) = delete;
  H5File& operator=(H5File&&) = delete;
  ~H5File();
  // Writes all that is pending; tells what the disk refused since the file was opened. Without it
  // (the destructor) a written file counts for nothing.
  void close();

  // --- The tree. Paths are absolute, "/snapshots/00000"; parents are made as needed.
  void make_group(const std::string& path);
  void remove(const std::string& path);
  bool has(const std::string& path) const;
  bool is_group(const std::string& path) const;
  std::vector<std::string> children(const std::string& group) const;  // by name
  Shape shape(const std::string& dataset) const;

  // --- Datasets of numbers
  template <class T>
  void write(const std::string& path, std::span<const T> values, const Storage& storage) {
    write_block(path, {number_of<T>(), values.data(), {values.size(), width_of<T>()}}, storage);
  }
  template <class T>
  std::vector<T> read(const std::string& path) const {
    std::vector<T> values(rows_of(path, width_of<T>()));
    read_block(path, number_of<T>(), values.data());
    return values;
  }
  void extend(const std::string& path, std::span<const double> values);  // extendible only
  void shorten(const std::string& path, std::size_t rows);               // likewise

  // --- Lists of texts (UTF-8)
  void write_texts(const std::string& path, const std::vector<std::string>& texts);
  std::vector<std::string> read_texts(const std::string& path) const;

  // --- Attributes of a group or dataset
  void set_attribute(const std::string& path, const std::string& name, std::string_view text);
  void set_attribute(const std::string& path, const std::string& name, double value);
  bool has_attribute(const std::string& path, const std::string& name) const;
  std::string text_attribute(const std::string& path, const std::string& name) const;
  double number_attribute(const std::string& path, const std::string& name) const;
  std::vector<std::string> attributes(const std::string& path) const;  // names

  const std::filesystem::path& path() const { return path_; }

 private:
  struct Block {
    Number number;
    const void* data;
    Shape shape;
  };
  H5File(std::filesystem::path path, std::int64_t id, std::unique_ptr<int> refusal)
      : path_(std::move(path)), id_(id), refusal_(std::move(refusal)) {}
  void write_block(const std::string& path, const Block& block, const Storage& storage);
  void read_block(const std::string& path, Number number, void* data) const;
  std::size_t rows_of(const std::string& path, std::size_t width) const;

  std::filesystem::path path_;
  std::int64_t id_ = -1;
  std::unique_ptr<int> refusal_;  // of the disk, errno; none where the file is only read
};

// Marks a new file as ours: root attributes `format` and `format_version`.
void set_format(H5File& file, std::string_view format, int version);
// CaseError unless the file bears this format and this version.
void require_format(const H5File& file, std::string_view format, int version);

}  // namespace pmr::io
