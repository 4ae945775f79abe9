#include "io/snapshot.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <numeric>

#include "pmr/base/errors.hpp"

namespace pmr::io {
namespace {

constexpr std::array<std::string_view, 4> phase_names{"fill", "mix", "react", "done"};
constexpr std::string_view folder = "/snapshots/";

Phase phase_of(const H5File& file, const std::string& group) {
  const std::string name = file.text_attribute(group, "phase");
  const auto found = std::find(phase_names.begin(), phase_names.end(), name);
  if (found == phase_names.end())
    throw CaseError({Fault{file.path().string(), group, "phase \"" + name + "\" is not known"}});
  return static_cast<Phase>(found - phase_names.begin());
}

void write_count(H5File& file, std::size_t count) {
  const std::string path = vertices_path(count);
  if (file.has(path)) return;
  std::vector<std::uint32_t> vertices(count);
  std::iota(vertices.begin(), vertices.end(), 0U);
  file.write(path, std::span<const std::uint32_t>(vertices),
             {"1", Number::uint32, Packing::deflated});
}

}  // namespace

std::string_view phase_name(Phase phase) { return phase_names.at(static_cast<std::size_t>(phase)); }

std::optional<Number> snapshot_number(std::string_view field) {
  if (field == "force" || field == "torque") return std::nullopt;
  if (field == "id") return Number::uint32;
  if (field == "species") return Number::uint8;
  if (field == "velocity" || field == "spin" || field == "enthalpy") return Number::float32;
  return Number::float64;
}

void write_snapshot(H5File& file, const std::string& group, const Snapshot& snapshot) {
  file.make_group(group);
  file.set_attribute(group, "time", snapshot.time);
  file.set_attribute(group, "phase", phase_name(snapshot.phase));
  for_each_field(snapshot.particles,
                 [&]<class T>(const char* name, const char* unit, const std::vector<T>& values) {
                   const auto number = snapshot_number(name);
                   if (number)
                     file.write(group + "/" + name, std::span<const T>(values),
                                {unit, *number, Packing::deflated});
                 });
  file.write(group + "/wall_temperature", std::span<const double>(snapshot.wall_temperature),
             {"K", Number::float64, Packing::deflated});
  if (!snapshot.adhered.empty())
    file.write(group + "/adhered", std::span<const Vec3>(snapshot.adhered),
               {"m", Number::float32, Packing::deflated});
}

Snapshot load_snapshot(const H5File& file, const std::string& group) {
  Snapshot snapshot;
  snapshot.time = file.number_attribute(group, "time");
  snapshot.phase = phase_of(file, group);
  resize(snapshot.particles, file.shape(group + "/id").rows);
  for_each_field(snapshot.particles,
                 [&]<class T>(const char* name, const char*, std::vector<T>& values) {
                   if (!snapshot_number(name)) return;
                   const std::size_t count = values.size();
                   values = file.read<T>(group + "/" + name);
                   if (values.size() != count)
                     throw CaseError({Fault{file.path().string(), group + "/" + name,
                                            std::to_string(count) + " rows wanted"}});
                 });
  snapshot.wall_temperature = file.read<double>(group + "/wall_temperature");
  if (file.has(group + "/adhered")) snapshot.adhered = file.read<Vec3>(group + "/adhered");
  return snapshot;
}

std::vector<std::string> snapshot_groups(const H5File& file) {
  std::vector<std::string> names = file.children("/snapshots");
  // Beyond 99999 a name is longer and comes later.
  std::sort(names.begin(), names.end(), [](const std::string& a, const std::string& b) {
    return a.size() != b.size() ? a.size() < b.size() : a < b;
  });
  for (std::string& name : names) name.insert(0, folder);
  return names;
}

std::string vertices_path(std::size_t count) { return "/vertices/" + std::to_string(count); }

void write_vertices(H5File& file) {
  for (const std::string& group : snapshot_groups(file)) {
    write_count(file, file.shape(group + "/id").rows);
    if (file.has(group + "/adhered")) write_count(file, file.shape(group + "/adhered").rows);
  }
}

std::string next_snapshot_group(const std::vector<std::string>& groups) {
  const unsigned long number =
      groups.empty() ? 0 : std::stoul(groups.back().substr(folder.size())) + 1;
  std::array<char, 24> digits{};
  std::snprintf(digits.data(), digits.size(), "%05lu", number);
  return std::string(folder) + digits.data();
}

}  // namespace pmr::io
