// Charts of the mixture, each for one run or for several in one figure.
#pragma once
#include <string>
#include <vector>

#include "report/mixture_data.hpp"
#include "report/page.hpp"

namespace pmr::report {

// A run with its bed; `name` labels its lines.
struct Bed {
  std::string name;
  MixtureData mixture;
  bool is_demonstrator;  // whose measured profile is known in words
};

// Mean w per layer over depth.
std::string layer_chart(const std::vector<Bed>& beds, Charts& charts);
// w over azimuth, a panel for each layer.
std::string azimuth_chart(const std::vector<Bed>& beds, Charts& charts);
// The bed unrolled: azimuth by layer, colours over the log of w.
std::string unrolled_chart(const Bed& bed, const std::string& id, const std::string& title,
                           Charts& charts);

}  // namespace pmr::report
