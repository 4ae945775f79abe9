// The sentences at the head of the page, made from the run's numbers: first what users ask for.
#include <algorithm>
#include <cmath>

#include "io/series.hpp"
#include "report/figures.hpp"
#include "report/mixture_data.hpp"

namespace pmr::report {
namespace {

std::string escaped(const std::string& name) { return escape(chemical(name)); }

std::string emphasised(const std::string& html) { return element("strong", html); }

std::string rest_sentence(const RunData& run) {
  const double settled = run.settled_time();
  const double lost = run.summary.number("mechanics/lost");
  std::string text;
  if (std::isfinite(settled) && run.summary.text("status") != "failed")
    text += "; the bed was at rest " + with_unit(Quantity::time, settled) + " after release";
  if (std::isfinite(lost))
    text += lost == 0.0 ? " with no particle lost"
                        : ", and " + with_unit(Quantity::count, lost) + " particles were lost";
  return text;
}

std::string what_was_done(const RunData& run) {
  const bool is_mixing =
      std::isfinite(run.summary.number("mechanics/lost")) || std::isfinite(run.settled_time());
  const std::string moved = run.species.size() > 1 ? " were mixed" : " were moved";
  return charge(run) + (is_mixing ? moved + rest_sentence(run) : " were simulated") + ".";
}

std::string broken_off(const RunData& run) {
  const std::string status = run.summary.text("status");
  if (status != "failed" && status != "stopped") return "";
  return emphasised("This run " + std::string(status == "failed" ? "failed" : "was stopped") +
                    " before its end.");
}

std::string granules(const RunData& run) {
  return "the " + escaped(run.species[run.granules()].name) + " granules";
}

// "the granules were hottest after 8.3 s: 812.3 °C on average (+112.3 K), alike within ±7.8 K".
std::string hottest_part(const RunData& run) {
  const auto hottest = granules_hottest(run);
  if (!hottest) return "";
  const std::string mean = emphasised(with_unit(Quantity::temperature, hottest->mean));
  if (!hottest->is_rise)
    return granules(run) + " were never warmer on average than at the start, " + mean;
  std::string text = granules(run) + " were hottest after " +
                     with_unit(Quantity::time, hottest->time) + ": " + mean + " on average";
  const double rise = hottest->mean - run.species[run.granules()].first_temperature;
  text += " (" + difference(Quantity::temperature_difference, rise) + ")";
  if (std::isfinite(hottest->spread))
    text += ", alike within ±" + with_unit(Quantity::temperature_difference, hottest->spread);
  return text;
}

std::string amount_of_oxygen(const RunData& run, double amount) {  // amount [mol]
  return with_unit(Quantity::specific_amount, amount / run.reactive_mass()) + " O₂";
}

std::string oxygen_peak_part(const RunData& run) {
  const auto peak = io::peak_of(run.series, "oxygen_released");
  if (run.reactive().empty() || !peak || !(peak->value > 0.0)) return "";
  return "the most oxygen was off after " + with_unit(Quantity::time, peak->time) + ": " +
         emphasised(amount_of_oxygen(run, peak->value));
}

std::string temperature_part(const RunData& run) {
  const std::string& name = run.species[run.granules()].name;
  const double mean = run.summary.number("thermal/temperature_mean/" + name);
  if (!std::isfinite(mean)) return "";
  const double change = mean - run.species[run.granules()].first_temperature;
  std::string text =
      granules(run) + " were at " + emphasised(with_unit(Quantity::temperature, mean));
  if (std::abs(change) > 0.05)
    text += " (" + difference(Quantity::temperature_difference, change) + ")";
  const double spread = run.summary.number("thermal/temperature_std/" + name);
  if (std::isfinite(spread))
    text += ", alike within ±" + with_unit(Quantity::temperature_difference, spread);
  return text;
}

std::string oxygen_part(const RunData& run) {
  const double released = run.summary.number("chemistry/oxygen_released");
  const auto reactive = run.reactive();
  if (reactive.empty() || !std::isfinite(released)) return "";
  const double from = run.summary.number("chemistry/delta_initial");
  const double to = run.summary.number("chemistry/delta_final");
  return (released < 0.0 ? "had taken up " : "had given off ") +
         emphasised(amount_of_oxygen(run, std::abs(released))) + " (" +
         (reactive.size() > 1 ? "mean " : "") + "δ from " + with_unit(Quantity::delta, from) +
         " to " + with_unit(Quantity::delta, to) + ")";
}

std::string mixture_part(const RunData& run) {
  const auto layers = mixture_of(run).layers;
  if (layers.empty()) return "";
  return "the mass ratio w runs from " +
         emphasised(with_unit(Quantity::ratio, layers.front().whole)) + " in the top layer to " +
         emphasised(with_unit(Quantity::ratio, layers.back().whole)) + " in the lowest";
}

std::string join_parts(std::vector<std::string> parts) {
  std::erase(parts, "");
  return join(parts, " and ");
}

std::string sentence(std::vector<std::string> parts) {
  std::string text = join_parts(std::move(parts));
  if (text.empty()) return "";
  if (text.front() >= 'a' && text.front() <= 'z')
    text.front() = static_cast<char>(text.front() - 'a' + 'A');
  return text + ".";
}

// Of the instrument `[conductivity]`: least and largest value, and how they compare.
std::string conductivity_part(const RunData& run) {
  const auto& points = run.summary.items("effective_conductivity/points");
  if (points.empty()) return "";
  const auto value = [](const Value& p) { return p.number("conductivity"); };
  const auto ratio = [&](const Value& p) { return value(p) / p.number("zehner_bauer_schluender"); };
  const auto range = [&](const auto& figure) {
    return std::minmax_element(points.begin(), points.end(), [&](const Value& a, const Value& b) {
      return figure(a) < figure(b);
    });
  };
  const auto told = [&](const Value& p) {
    return emphasised(fixed(value(p), 2) + " W/m/K") + " (" +
           with_unit(Quantity::pressure, p.number("pressure")) + ", " +
           with_unit(Quantity::temperature, p.number("temperature")) + ")";
  };
  const auto [least, most] = range(value);
  const auto [lowest, highest] = range(ratio);
  return "the bed conducts " + told(*least) + " to " + told(*most) + ", " +
         fixed(ratio(*lowest), 2) + " to " + fixed(ratio(*highest), 2) +
         " times what the correlation of Zehner, Bauer and Schl\u00fcnder has";
}

// Of the instruments `[heap]` and `[catch.NAME]`: the angle, when a threshold was reached, what was
// caught.
std::string bulk_part(const RunData& run) {
  std::vector<std::string> parts, caught;
  const double angle = run.summary.number("heap/angle");
  if (std::isfinite(angle))
    parts.push_back("the angle of repose is " +
                    emphasised(fixed(angle, 1) + " ± " +
                               fixed(run.summary.number("heap/angle_scatter"), 1) + " deg"));
  for (const Member& m : run.summary.members("catch")) {
    const double threshold = m.value.number("threshold"), mass = m.value.number("mass");
    const double time = m.value.number("time_to_threshold");
    if (std::isfinite(time))
      parts.push_back(with_unit(Quantity::mass, threshold) + " were caught by " + escape(m.key) +
                      " after " + emphasised(with_unit(Quantity::time, time)));
    else if (mass > 0.0)
      caught.push_back(emphasised(with_unit(Quantity::mass, mass)) + " by " + escape(m.key));
  }
  if (!caught.empty()) parts.push_back("caught were " + join(caught, ", "));
  return join_parts(std::move(parts));
}

// What it is about: a bulk test, the bed's conductivity, heat and oxygen, or the mixture alone.
std::string outcome(const RunData& run) {
  if (const std::string bulk = bulk_part(run); !bulk.empty()) return sentence({bulk});
  if (const std::string conductivity = conductivity_part(run); !conductivity.empty())
    return sentence({conductivity});
  if (!run.summary.has("thermal")) return sentence({mixture_part(run)});
  return sentence({hottest_part(run), oxygen_peak_part(run)});
}

std::string at_the_end(const RunData& run) {
  if (run.summary.has("effective_conductivity")) return "";
  const std::string end = join_parts({temperature_part(run), oxygen_part(run)});
  if (end.empty()) return "";
  return "At the end, after " + with_unit(Quantity::time, run.end_time()) + ", " + end + ".";
}

std::string carried_by(const RunData& run) {
  struct Path {
    const char* key;
    const char* name;
  };
  static constexpr Path paths[] = {
      {"radiation", "radiation"}, {"contact", "contacts"}, {"gap", "gas gaps"}};
  double total = 0.0;
  for (const Path& p : paths) total += run.summary.number("heat_paths/" + std::string(p.key));
  if (!std::isfinite(total) || std::abs(total) < 1.0) return "";
  std::vector<std::string> shares;
  for (const Path& p : paths)
    shares.push_back(
        with_unit(Quantity::share, run.summary.number("heat_paths/" + std::string(p.key)) / total) +
        " by " + p.name);
  return "the granules received " + with_unit(Quantity::energy, total) + " from the beads, " +
         join(shares, ", ");
}

std::string trust(const RunData& run) {
  const double energy = std::abs(run.summary.number("balances/energy_relative"));
  const double oxygen = std::abs(run.summary.number("balances/oxygen_relative"));
  std::string books;
  if (std::isfinite(energy))
    books = "the books close to " + with_unit(Quantity::residual, energy) +
            " of the heat and gas turned over";
  if (std::isfinite(energy) && std::isfinite(oxygen))
    books += " and " + with_unit(Quantity::residual, oxygen) + " of the oxygen";
  const std::string heat = carried_by(run);
  if (heat.empty() && books.empty()) {
    const double overlap = run.summary.number("mechanics/max_overlap_ratio");
    if (!std::isfinite(overlap)) return "";
    return "The largest overlap of two particles was " + with_unit(Quantity::share, overlap) +
           " of a radius.";
  }
  std::vector<std::string> parts{heat, books};
  std::erase(parts, "");
  return sentence({join(parts, "; ")});
}

}  // namespace

std::string charge(const RunData& run) {
  std::vector<std::string> parts;
  for (const SpeciesTotals& s : run.species) {
    std::string text = emphasised(with_unit(Quantity::mass, s.mass) + " " + escaped(s.name));
    text += " (" + with_unit(Quantity::count, static_cast<double>(s.count)) + " spheres)";
    if (s.first_temperature > 0.0)
      text += " at " + with_unit(Quantity::temperature, s.first_temperature);
    parts.push_back(text);
  }
  return join(parts, " and ");
}

std::vector<std::string> answer(const RunData& run) {
  if (run.species.empty()) return {};
  std::string first = broken_off(run);
  for (const std::string& part : {outcome(run), at_the_end(run)})
    if (!part.empty()) first += (first.empty() ? "" : " ") + part;
  std::vector<std::string> sentences{first, what_was_done(run), trust(run)};
  std::erase(sentences, "");
  return sentences;
}

}  // namespace pmr::report
