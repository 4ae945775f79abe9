// Objects of summary.json that have files of their own.
#pragma once
#include <nlohmann/json.hpp>

#include "sim/summary.hpp"

namespace pmr::sim {

using Json = nlohmann::ordered_json;

// JSON knows no infinity and no NaN.
Json number(double value);

// "catch", "heap" and "wall_force" of what the case has.
void add_bulk_tests(const SummaryInput& in, Json& summary);
Json chemistry_of(const SummaryInput& in);  // null without a redox species
Json yield_of(const SummaryInput& in);
Json heat_paths_of(const SummaryInput& in);
Json species_books_of(const SummaryInput& in);  // energy and oxygen of each species

}  // namespace pmr::sim
