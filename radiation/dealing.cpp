#include "radiation/dealing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace pmr::radiation {
namespace {

constexpr double always_allowed = 1e7;     // [1] rays of one tracing: some seconds
constexpr double most_per_emitter = 20.0;  // [1] mean over emitters, of the smallest one's rays

}  // namespace

double Dealing::wanted(double emission) const {
  return std::max(1.0, std::round(rays * emission / least));
}

double Dealing::sent(double emission) const { return std::min(wanted(emission), most); }

Dealing deal(std::span<const double> emission, double least, double rays) {
  Dealing dealing{rays, least, std::numeric_limits<double>::infinity()};
  std::vector<double> wanted;
  for (const double e : emission) wanted.push_back(dealing.wanted(e));
  double left =
      std::max(always_allowed, most_per_emitter * rays * static_cast<double>(emission.size()));
  if (std::accumulate(wanted.begin(), wanted.end(), 0.0) <= left) return dealing;
  std::sort(wanted.begin(), wanted.end());
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    const double share = left / static_cast<double>(wanted.size() - k);
    if (wanted[k] > share) {
      dealing.most = std::max(1.0, std::floor(share));
      break;
    }
    left -= wanted[k];
  }
  return dealing;
}

}  // namespace pmr::radiation
