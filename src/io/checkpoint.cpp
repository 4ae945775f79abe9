#include <string>
#include <system_error>

#include "io/atomic_file.hpp"
#include "io/hdf5.hpp"
#include "io/run_file.hpp"
#include "io/state_members.hpp"
#include "pmr/base/errors.hpp"

namespace pmr::io {
namespace {

constexpr const char* checkpoint_format = "pmr-checkpoint";
constexpr int checkpoint_version = 5;  // of the layout in docs/file-formats.md

std::filesystem::path checkpoint_path(const std::filesystem::path& dir) {
  return dir / "checkpoint.h5";
}

// A visitor that writes below a group. Numbers become datasets of one row, so that every figure
// has its unit; truth values and phases are bytes.
class Writer {
 public:
  Writer(H5File& file, std::string group) : file_(file), group_(std::move(group)) {}

  template <class T>
  void operator()(const std::string& name, const char* unit, const std::vector<T>& values) const {
    file_.write(group_ + name, std::span<const T>(values),
                {unit, number_of<T>(), Packing::checked});
  }
  template <class T>
  requires std::is_scalar_v<T>
  void operator()(const std::string& name, const char* unit, const T& value) const {
    if constexpr (std::is_enum_v<T> || std::is_same_v<T, bool>)
      (*this)(name, unit, std::vector{static_cast<std::uint8_t>(value)});
    else
      (*this)(name, unit, std::vector{value});
  }

 private:
  H5File& file_;
  std::string group_;
};

class Reader {
 public:
  Reader(const H5File& file, std::string group) : file_(file), group_(std::move(group)) {}

  template <class T>
  void operator()(const std::string& name, const char*, std::vector<T>& values) const {
    values = file_.read<T>(group_ + name);
  }
  template <class T>
  requires std::is_scalar_v<T>
  void operator()(const std::string& name, const char*, T& value) const {
    using Stored =
        std::conditional_t<std::is_enum_v<T> || std::is_same_v<T, bool>, std::uint8_t, T>;
    const std::vector<Stored> values = file_.read<Stored>(group_ + name);
    if (values.size() != 1)
      throw CaseError({Fault{file_.path().string(), group_ + name, "one number wanted"}});
    value = static_cast<T>(values.front());
  }

 private:
  const H5File& file_;
  std::string group_;
};

void write_lost(H5File& file, const std::vector<LostParticle>& lost) {
  std::vector<ParticleId> id;
  std::vector<double> time;
  std::vector<Vec3> position;
  for (const LostParticle& particle : lost) {
    id.push_back(particle.id);
    time.push_back(particle.time);
    position.push_back(particle.position);
  }
  const Writer write(file, "/lost/");
  write("id", "1", id);
  write("time", "s", time);
  write("position", "m", position);
}

std::vector<LostParticle> read_lost(const H5File& file) {
  const auto id = file.read<ParticleId>("/lost/id");
  const auto time = file.read<double>("/lost/time");
  const auto position = file.read<Vec3>("/lost/position");
  std::vector<LostParticle> lost;
  for (std::size_t i = 0; i < id.size(); ++i) lost.push_back({id[i], time.at(i), position.at(i)});
  return lost;
}

template <class Get>
auto column(const std::vector<CaughtParticle>& caught, const Get& get) {
  std::vector<std::decay_t<decltype(get(caught.front()))>> values;
  for (const CaughtParticle& particle : caught) values.push_back(get(particle));
  return values;
}

void write_caught(H5File& file, const std::vector<CaughtParticle>& caught) {
  if (caught.empty()) return;
  const Writer write(file, "/caught/");
  write("id", "1", column(caught, [](const CaughtParticle& p) { return p.id; }));
  write("species", "1", column(caught, [](const CaughtParticle& p) { return p.species; }));
  write("by", "1", column(caught, [](const CaughtParticle& p) { return p.by; }));
  write("time", "s", column(caught, [](const CaughtParticle& p) { return p.time; }));
  write("mass", "kg", column(caught, [](const CaughtParticle& p) { return p.mass; }));
  write("position", "m", column(caught, [](const CaughtParticle& p) { return p.position; }));
}

std::vector<CaughtParticle> read_caught(const H5File& file) {
  std::vector<CaughtParticle> caught;
  if (!file.has("/caught")) return caught;
  const auto id = file.read<ParticleId>("/caught/id");
  const auto species = file.read<SpeciesIndex>("/caught/species");
  const auto by = file.read<std::uint32_t>("/caught/by");
  const auto time = file.read<double>("/caught/time");
  const auto mass = file.read<double>("/caught/mass");
  const auto position = file.read<Vec3>("/caught/position");
  for (std::size_t i = 0; i < id.size(); ++i)
    caught.push_back({id[i], species.at(i), by.at(i), time.at(i), mass.at(i), position.at(i)});
  return caught;
}

bool fits(const ContactHistory& history, std::size_t particles) {
  const std::size_t contacts = history.partner.size();
  return !history.start.empty() && history.start.back() == contacts &&
         (history.start.size() == particles + 1 || history.start.size() == 1) &&
         history.tangential.size() == contacts && history.rolling.size() == contacts;
}

// Lengths that belong together do; a file that was cut or mixed is refused here.
void require_consistent(const std::filesystem::path& path, const State& state) {
  const std::size_t count = state.particles.size();
  bool holds = fits(state.pair_contacts, count) && fits(state.wall_contacts, count);
  for_each_field(state.particles, [&](const char*, const char*, const auto& field) {
    holds = holds && field.size() == count;
  });
  const Csr& factor = state.exchange.factor;
  holds = holds && !factor.start.empty() && factor.start.back() == factor.value.size() &&
          factor.column.size() == factor.value.size() && state.phase <= Phase::done;
  if (!holds)
    throw CaseError({Fault{path.string(), "", "fields of one length wanted, found several"}});
}

// HDF5 checks the content of its chunks, not where they are said to lie.
std::string hash_text(const State& state) { return std::to_string(state_hash(state)); }

}  // namespace

void save_checkpoint(const std::filesystem::path& dir, const State& state) {
  Replacement replacement(checkpoint_path(dir));
  H5File file = H5File::create(replacement.temporary());
  set_format(file, checkpoint_format, checkpoint_version);
  for_each_field(state.particles, Writer(file, "/particles/"));
  if (state.waiting.size() > 0) for_each_field(state.waiting, Writer(file, "/waiting/"));
  for_each_contact_field(state.pair_contacts, Writer(file, "/pair_contacts/"));
  for_each_contact_field(state.wall_contacts, Writer(file, "/wall_contacts/"));
  for_each_ordered_field(state, Writer(file, "/"));
  write_lost(file, state.lost);
  write_caught(file, state.caught);
  file.set_attribute("/", "state_hash", hash_text(state));
  file.close();
  replacement.commit();
}

State load_checkpoint(const std::filesystem::path& dir) {
  const std::filesystem::path path = checkpoint_path(dir);
  const H5File file = H5File::open(path);
  require_format(file, checkpoint_format, checkpoint_version);
  State state;
  for_each_field(state.particles, Reader(file, "/particles/"));
  if (file.has("/waiting")) for_each_field(state.waiting, Reader(file, "/waiting/"));
  for_each_contact_field(state.pair_contacts, Reader(file, "/pair_contacts/"));
  for_each_contact_field(state.wall_contacts, Reader(file, "/wall_contacts/"));
  for_each_ordered_field(state, Reader(file, "/"));
  state.lost = read_lost(file);
  state.caught = read_caught(file);
  require_consistent(path, state);
  if (!file.has_attribute("/", "state_hash") ||
      file.text_attribute("/", "state_hash") != hash_text(state))
    throw CaseError({Fault{path.string(), "", "is damaged: its content is not what was written"}});
  return state;
}

bool has_checkpoint(const std::filesystem::path& dir) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(checkpoint_path(dir), ignored);
}

}  // namespace pmr::io
