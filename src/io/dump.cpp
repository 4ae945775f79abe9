#include "io/dump.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string>

#include "pmr/base/errors.hpp"

namespace pmr::io {
namespace {

constexpr std::size_t most_faults = 10;   // that are told one by one
constexpr double smallest_radius = 1e-6;  // [m] dust; below, the unit cannot be the metre
constexpr double largest_radius = 50e-3;  // [m] likewise above

// The columns that are read, in the order of `Layout::place`.
enum Wanted : std::size_t { id, type, radius, x, y, z, vx, vy, vz, omegax, omegay, omegaz, count };
constexpr std::array<const char*, count> names{"id", "type", "radius", "x",      "y",     "z", "vx",
                                               "vy", "vz",   "omegax", "omegay", "omegaz"};

struct Layout {
  std::array<std::ptrdiff_t, count> place;  // [1] column of each quantity, -1: not there
  std::size_t columns = 0;
  bool has(Wanted wanted) const { return place[wanted] >= 0; }
};

std::vector<std::string> words_of(const std::string& line) {
  std::istringstream in(line);
  std::vector<std::string> words;
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

// Reads one frame line by line, and collects what is wrong with it.
class Frame {
 public:
  explicit Frame(std::filesystem::path file)
      : file_(std::move(file)), in_(file_, std::ios::binary) {
    if (!in_) stop("cannot be read");
    seek_last();
  }

  Dump read() {
    Dump dump;
    dump.time_step = number_after("ITEM: TIMESTEP");
    const std::uint64_t announced = number_after("ITEM: NUMBER OF ATOMS");
    expect("ITEM: BOX BOUNDS");
    for (int side = 0; side < 3; ++side) next();
    expect("ITEM: ATOMS");
    const Layout layout = read_layout();
    if (!faults_.empty()) throw CaseError(std::move(faults_));
    dump.atoms.reserve(std::min<std::uint64_t>(announced, 1U << 24));
    for (std::uint64_t k = 0; k < announced; ++k) {
      if (!std::getline(in_, line_))
        stop("ends after " + std::to_string(k) + " of " + std::to_string(announced) + " atoms");
      ++number_;
      read_atom(layout, dump);
    }
    std::sort(dump.atoms.begin(), dump.atoms.end(), [](const DumpAtom& a, const DumpAtom& b) {
      return a.id != b.id ? a.id < b.id : a.line < b.line;
    });
    find_duplicates(dump);
    if (dropped_ > 0)
      faults_.push_back({file_.string(), "", std::to_string(dropped_) + " more faults"});
    if (!faults_.empty()) throw CaseError(std::move(faults_));
    return dump;
  }

 private:
  // To the line of the last "ITEM: TIMESTEP".
  void seek_last() {
    std::streampos last = -1, here = 0;
    std::size_t number = 0, last_number = 0;
    for (; std::getline(in_, line_); ++number, here = in_.tellg())
      if (line_.rfind("ITEM: TIMESTEP", 0) == 0) {
        last = here;
        last_number = number;
      }
    if (last < 0) stop("is no text dump; wanted a line 'ITEM: TIMESTEP'");
    in_.clear();
    in_.seekg(last);
    number_ = last_number;
  }

  std::string where() const { return file_.string() + ":" + std::to_string(number_); }

  [[noreturn]] void stop(const std::string& problem) const {
    throw CaseError({{number_ == 0 ? file_.string() : where(), "", problem}});
  }

  void fault(const std::string& key, const std::string& problem) {
    if (faults_.size() < most_faults)
      faults_.push_back({where(), key, problem});
    else
      ++dropped_;
  }

  void next() {
    ++number_;
    if (!std::getline(in_, line_)) stop("the frame is cut short");
  }

  void expect(const std::string& start) {
    next();
    if (line_.rfind(start, 0) != 0) stop("wanted '" + start + "', found '" + line_ + "'");
  }

  std::uint64_t number_after(const std::string& start) {
    expect(start);
    next();
    std::uint64_t value = 0;
    if (std::from_chars(line_.data(), line_.data() + line_.size(), value).ec != std::errc{})
      stop("wanted a whole number, found '" + line_ + "'");
    return value;
  }

  Layout read_layout() {
    std::vector<std::string> words = words_of(line_);
    words.erase(words.begin(), words.begin() + 2);
    Layout layout{{}, words.size()};
    const auto place = [&](const std::string& name) {
      const auto found = std::find(words.begin(), words.end(), name);
      return found == words.end() ? std::ptrdiff_t{-1} : found - words.begin();
    };
    for (std::size_t k = 0; k < count; ++k) layout.place[k] = place(names[k]);
    for (const Wanted wanted : {id, type, radius, x, y, z})
      if (!layout.has(wanted)) fault(names[wanted], missing(names[wanted], place));
    require_three(layout, vx);
    require_three(layout, omegax);
    return layout;
  }

  template <class Place>
  static std::string missing(const std::string& name, const Place& place) {
    for (const char* suffix : {"s", "u", "su"})
      if (name.size() == 1 && place(name + suffix) >= 0)
        return "the dump has '" + name + suffix +
               "', scaled or unwrapped; wanted x y z in metres (dump ... custom ... x y z)";
    return "the column is missing; wanted id type radius x y z";
  }

  // Three components, or none.
  void require_three(const Layout& layout, Wanted first) {
    std::size_t found = 0;
    for (std::size_t k = first; k < first + 3U; ++k) found += layout.place[k] >= 0 ? 1 : 0;
    if (found != 0 && found != 3) fault(names[first], "wanted all three components of it, or none");
  }

  void read_atom(const Layout& layout, Dump& dump) {
    cells_.clear();
    const char *at = line_.data(), *const end = at + line_.size();
    const auto is_space = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
    while (true) {
      while (at != end && is_space(*at)) ++at;
      if (at == end) break;
      const char* first = at;
      while (at != end && !is_space(*at)) ++at;
      cells_.push_back({first, static_cast<std::size_t>(at - first)});
    }
    if (cells_.size() != layout.columns)
      return fault("", "has " + std::to_string(cells_.size()) + " columns; the frame has " +
                           std::to_string(layout.columns));
    const std::size_t before = faults_.size() + dropped_;
    DumpAtom atom{0, 0, 0.0, Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), number_};
    atom.id = whole(layout, id);
    atom.type = whole(layout, type);
    atom.radius = real(layout, radius);
    atom.position = vector(layout, x);
    if (layout.has(vx)) atom.velocity = vector(layout, vx);
    if (layout.has(omegax)) atom.spin = vector(layout, omegax);
    if (faults_.size() + dropped_ > before) return;
    if (atom.radius < smallest_radius || atom.radius > largest_radius)
      fault("radius", "is " + cell(layout, radius) +
                          " m; wanted 1e-6 to 0.05 m: is the dump in another unit than SI?");
    dump.atoms.push_back(atom);
  }

  std::string cell(const Layout& layout, Wanted wanted) const {
    return std::string(cells_[static_cast<std::size_t>(layout.place[wanted])]);
  }

  template <class Number>
  Number parse(const Layout& layout, Wanted wanted, const char* what) {
    const std::string_view text = cells_[static_cast<std::size_t>(layout.place[wanted])];
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    bool is_good = error == std::errc{} && end == text.data() + text.size();
    if constexpr (std::is_floating_point_v<Number>) is_good = is_good && std::isfinite(value);
    if (!is_good) fault(names[wanted], "'" + std::string(text) + "' is no " + what);
    return value;
  }
  std::uint64_t whole(const Layout& layout, Wanted wanted) {
    return parse<std::uint64_t>(layout, wanted, "whole number");
  }
  double real(const Layout& layout, Wanted wanted) {
    return parse<double>(layout, wanted, "finite number");
  }
  Vec3 vector(const Layout& layout, Wanted first) {
    Vec3 v;
    for (std::size_t a = 0; a < 3; ++a)
      v[static_cast<Eigen::Index>(a)] = real(layout, static_cast<Wanted>(first + a));
    return v;
  }

  void find_duplicates(const Dump& dump) {
    for (std::size_t k = 1; k < dump.atoms.size(); ++k)
      if (dump.atoms[k].id == dump.atoms[k - 1].id) {
        number_ = dump.atoms[k].line;
        fault("id", "atom " + std::to_string(dump.atoms[k].id) + " stands in line " +
                        std::to_string(dump.atoms[k - 1].line) + " already");
      }
  }

  std::filesystem::path file_;
  std::ifstream in_;
  std::size_t number_ = 0;  // [1] of the line, from 1
  std::string line_;
  std::vector<std::string_view> cells_;  // of the line
  std::vector<Fault> faults_;
  std::size_t dropped_ = 0;  // faults beyond those that are told
};

}  // namespace

Dump read_dump(const std::filesystem::path& file) { return Frame(file).read(); }

bool is_dump(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::string word;
  return in >> word && word == "ITEM:";
}

}  // namespace pmr::io
