#include "io/dump.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "pmr/base/errors.hpp"
#include "pmr/base/text.hpp"

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

std::vector<std::string_view> words_of(std::string_view line) {
  constexpr std::string_view blanks = " \t";
  std::vector<std::string_view> words;
  for (std::size_t at = 0; at < line.size();) {
    const std::size_t first = std::min(line.find_first_not_of(blanks, at), line.size());
    at = std::min(line.find_first_of(blanks, first), line.size());
    if (at > first) words.push_back(line.substr(first, at - first));
  }
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
    for (int side = 0; side < 3; ++side) pass_bounds();
    expect("ITEM: ATOMS");
    const Layout layout = read_layout();
    if (!faults_.empty()) throw CaseError(std::move(faults_));
    dump.atoms.reserve(std::min<std::uint64_t>(announced, 1U << 24));
    for (std::uint64_t k = 0; k < announced; ++k) {
      if (!next_line(in_, line_))
        stop("ends after " + std::to_string(k) + " of " + std::to_string(announced) + " atoms");
      ++number_;
      read_atom(layout, dump);
    }
    refuse_more_than(announced);
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
  // To the line of the last "ITEM: TIMESTEP"; units are told once, before the first of them.
  void seek_last() {
    skip_byte_order_mark(in_);
    std::streampos last = -1, here = in_.tellg();
    std::size_t last_number = 0;
    bool tells_units = false;
    for (number_ = 0; next_line(in_, line_); ++number_, here = in_.tellg()) {
      if (std::exchange(tells_units, line_.rfind("ITEM: UNITS", 0) == 0)) check_units();
      if (line_.rfind("ITEM: TIMESTEP", 0) != 0) continue;
      last = here;
      last_number = number_;
    }
    number_ = 0;
    if (last < 0) stop("is no text dump; wanted a line 'ITEM: TIMESTEP'");
    in_.clear();
    in_.seekg(last);
    number_ = last_number;
  }

  void check_units() {
    ++number_;
    if (trimmed(line_) != "si") stop("is in the units '" + line_ + "'; wanted a dump in si");
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
    if (!next_line(in_, line_)) stop("the frame is cut short");
  }

  void expect(const std::string& start) {
    next();
    if (line_.rfind(start, 0) != 0) stop("wanted '" + start + "', found '" + line_ + "'");
  }

  std::uint64_t number_after(const std::string& start) {
    expect(start);
    next();
    const auto value = whole_number(trimmed(line_));
    if (!value) stop("wanted a whole number, found '" + line_ + "'");
    return *value;
  }

  // "-0.05 0.05", or three numbers of a tilted box; particles are not held against it.
  void pass_bounds() {
    next();
    const std::vector<std::string_view> words = words_of(line_);
    const bool are_numbers =
        std::all_of(words.begin(), words.end(), [](const auto& w) { return finite_number(w); });
    if (words.size() < 2 || words.size() > 3 || !are_numbers)
      stop("wanted two numbers, the bounds of the box, found '" + line_ + "'");
  }

  // The frame is the last one: behind its atoms nothing may stand.
  void refuse_more_than(std::uint64_t announced) {
    for (; next_line(in_, line_);) {
      ++number_;
      if (trimmed(line_).empty()) continue;
      return fault("", "stands behind the " + std::to_string(announced) +
                           " atoms that the frame announces: '" + line_ + "'");
    }
  }

  Layout read_layout() {
    std::vector<std::string_view> words = words_of(line_);
    words.erase(words.begin(), words.begin() + 2);
    Layout layout{{}, words.size()};
    const auto place = [&](const std::string& name) {
      const auto found = std::find(words.begin(), words.end(), name);
      return found == words.end() ? std::ptrdiff_t{-1} : found - words.begin();
    };
    for (const char* name : names)
      if (std::count(words.begin(), words.end(), name) > 1) fault(name, "the column stands twice");
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
    cells_ = words_of(line_);
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
      fault("radius", "is " + std::string(cell(layout, radius)) +
                          " m; wanted 1e-6 to 0.05 m: is the dump in another unit than SI?");
    dump.atoms.push_back(atom);
  }

  std::string_view cell(const Layout& layout, Wanted wanted) const {
    return cells_[static_cast<std::size_t>(layout.place[wanted])];
  }

  template <class Number>
  Number known(const std::optional<Number>& number, const Layout& layout, Wanted wanted,
               const char* what) {
    if (!number) fault(names[wanted], "'" + std::string(cell(layout, wanted)) + "' is no " + what);
    return number.value_or(Number{});
  }
  std::uint64_t whole(const Layout& layout, Wanted wanted) {
    return known(whole_number(cell(layout, wanted)), layout, wanted, "whole number");
  }
  double real(const Layout& layout, Wanted wanted) {
    return known(finite_number(cell(layout, wanted)), layout, wanted, "finite number");
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
  std::ifstream in(file, std::ios::binary);
  skip_byte_order_mark(in);
  std::string word;
  return in >> word && word == "ITEM:";
}

}  // namespace pmr::io
