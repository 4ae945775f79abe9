#include "cli/mixture_print.hpp"

#include <fmt/format.h>

#include "instruments/course.hpp"
#include "instruments/mixing.hpp"
#include "instruments/section_ratios.hpp"

namespace pmr::cli {
namespace {

void print_layers(const instruments::BedSections& sections,
                  const instruments::SectionRatios& ratios,
                  const instruments::Asymmetry& asymmetry) {
  fmt::print("{:>8} {:>10} {:>10} {:>8} {:>8} {:>10}\n", "layer", "mass", "thickness", "w",
             "mean w", "left-right");
  for (std::size_t k = 0; k < ratios.size(); ++k) {
    const instruments::Layer& layer = sections.layers[k];
    fmt::print("{:>8} {:8.2f} g {:7.2f} mm {:8.3f} {:8.3f} {:8.1f} %\n", k + 1, 1e3 * layer.mass,
               1e3 * layer.thickness(), layer.content.mass_ratio(),
               instruments::sector_mean(ratios[k]), 100.0 * asymmetry.layers[k]);
  }
  fmt::print("{:>8} {:8.2f} g {:7.2f} mm {:8.3f}\n", "residuum", 1e3 * sections.residuum.mass,
             1e3 * sections.residuum.thickness(), sections.residuum.content.mass_ratio());
}

void print_deviation(const instruments::Deviation& from, const MixtureReference& reference) {
  fmt::print("deviation |1 - w/w_ref| from {}\n", reference.name);
  for (std::size_t k = 0; k < from.layers.size(); ++k) {
    fmt::print("{:>8} {:8.1f} % of w = {:.3f}", k + 1, 100.0 * from.layers[k], reference.layers[k]);
    if (!from.sections.empty())
      fmt::print(", {:.1f} % on average over the sections", 100.0 * from.sections[k]);
    fmt::print("\n");
  }
  fmt::print("{:>8} {:8.1f} %\n", "mean", 100.0 * from.mean);
}

}  // namespace

void print_mixture(const Case& setup, const Particles& bed) {
  const auto sections = instruments::decompose(setup, bed);
  if (!sections) return;
  const auto ratios = instruments::section_ratios(*sections);
  const auto asymmetry = instruments::left_right_asymmetry(ratios);
  print_layers(*sections, ratios, asymmetry);
  fmt::print("Lacey index {:.3f}; left-right asymmetry {:.1f} % on average, {:.1f} % at most\n",
             instruments::lacey_index(*sections), 100.0 * asymmetry.mean,
             100.0 * asymmetry.largest);
  if (const auto& reference = setup.decomposition->reference)
    print_deviation(instruments::deviation(ratios, *reference), *reference);
}

}  // namespace pmr::cli
