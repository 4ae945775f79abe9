#include "physics/contact_law.hpp"

#include <algorithm>

#include "physics/pair_kernel.hpp"
#include "pmr/base/constants.hpp"

namespace pmr::physics {
namespace {

// -ln e / sqrt(ln^2 e + pi^2) [1], its limit 1 at e = 0.
double damping_ratio(double restitution) {
  if (restitution <= 0.0) return 1.0;
  const double l = std::log(restitution);
  return -l / std::sqrt(l * l + pi * pi);
}

// 1/G* = 2 (2 - nu_a)(1 + nu_a)/Y_a + the same of b [Pa].
double effective_shear(const Material& a, const Material& b) {
  const auto compliance = [](const Material& m) {
    return 2.0 * (2.0 - m.poisson_soft) * (1.0 + m.poisson_soft) / m.young_soft;
  };
  return 1.0 / (compliance(a) + compliance(b));
}

}  // namespace

double effective_young(const Material& a, const Material& b) {
  const auto compliance = [](const Material& m) {
    return (1.0 - m.poisson_soft * m.poisson_soft) / m.young_soft;
  };
  return 1.0 / (compliance(a) + compliance(b));
}

ContactLaw contact_law(const Material& a, const Material& b, const PairContact& pair) {
  const double young = effective_young(a, b);
  const double tangential = 8.0 * effective_shear(a, b);
  const double ratio = damping_ratio(pair.restitution);
  return {.normal = 4.0 / 3.0 * young,
          .tangential = tangential,
          .normal_damping = 2.0 * ratio * std::sqrt(5.0 / 3.0 * young),
          .tangential_damping = 2.0 * ratio * std::sqrt(5.0 / 6.0 * tangential),
          .friction = pair.friction,
          .rolling_friction = pair.rolling_friction};
}

SingleContact single_contact(const ContactModel& model) {
  return std::visit(
      [](auto force, auto rolling) -> SingleContact {
        return evaluate<decltype(force), decltype(rolling), double>;
      },
      model.force, model.rolling);
}

namespace {

// Material of each kind of sphere.
std::vector<std::uint32_t> materials_of_kinds(const Case& c) {
  std::vector<std::uint32_t> kinds;
  for (const Species& species : c.species) kinds.push_back(species.material);
  const auto adhered = static_cast<std::ptrdiff_t>(kinds.size());
  for (const Grain& grain : c.walls.grains)
    if (std::find(kinds.begin() + adhered, kinds.end(), grain.material) == kinds.end())
      kinds.push_back(grain.material);
  return kinds;
}

}  // namespace

std::uint32_t ContactLaws::kind_of_adhered(const Case& c, std::uint32_t material) {
  const auto kinds = materials_of_kinds(c);
  const auto adhered = kinds.begin() + static_cast<std::ptrdiff_t>(c.species.size());
  return static_cast<std::uint32_t>(std::find(adhered, kinds.end(), material) - kinds.begin());
}

ContactLaws::ContactLaws(const Case& c)
    : model_(c.models.mechanics.contact),
      kinds_(materials_of_kinds(c).size()),
      materials_(c.materials.list.size()) {
  const auto law = [&](std::size_t a, std::size_t b) {
    return contact_law(c.materials.list[a], c.materials.list[b], c.materials.pair(a, b));
  };
  const std::vector<std::uint32_t> kinds = materials_of_kinds(c);
  for (const std::uint32_t i : kinds)
    for (const std::uint32_t j : kinds) pairs_.push_back(law(i, j));
  for (const Species& i : c.species)
    for (std::size_t m = 0; m < materials_; ++m) walls_.push_back(law(i.material, m));
}

double composite_restitution(const RestitutionSide& a, const RestitutionSide& b) {
  const auto weight = [](const RestitutionSide& s) {
    return std::pow(s.young / (1.0 - s.poisson * s.poisson) * std::sqrt(s.radius), 2.0 / 3.0);
  };
  const double wa = weight(a), wb = weight(b);
  return std::sqrt((a.restitution * a.restitution * wb + b.restitution * b.restitution * wa) /
                   (wa + wb));
}

LawPair places_of(const ContactModel& model) {
  return {model.force.index(), model.rolling.index()};
}

}  // namespace pmr::physics
