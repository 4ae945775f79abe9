#include "case/stl_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>

#include "pmr/base/text.hpp"

namespace pmr::casefile {
namespace {

constexpr std::size_t header = 84, record = 50;  // [bytes] of a binary file and its triangles

bool is_binary(const std::string& bytes) {
  if (bytes.size() < header) return false;
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + header - sizeof count, sizeof count);
  return bytes.size() == header + record * std::size_t{count};
}

// Each record: a normal and three corners of three floats, and two bytes of no meaning.
StlText from_binary(const std::string& bytes) {
  StlText out;
  for (std::size_t at = header; at < bytes.size(); at += record) {
    std::array<float, 12> numbers;
    std::memcpy(numbers.data(), bytes.data() + at, sizeof numbers);
    auto& corners = out.triangles.emplace_back();
    for (std::size_t k = 0; k < 3; ++k)
      corners[k] = {numbers[3 + 3 * k], numbers[4 + 3 * k], numbers[5 + 3 * k]};
  }
  return out;
}

// The words of a text in small letters, each with its line.
class Words {
 public:
  explicit Words(std::string_view text) : text_(text) {}

  // Empty at the end of the text.
  const std::string& next() {
    word_.clear();
    for (; at_ < text_.size() && is_blank(text_[at_]); ++at_) line_ += text_[at_] == '\n' ? 1 : 0;
    for (; at_ < text_.size() && !is_blank(text_[at_]); ++at_)
      word_ += static_cast<char>(std::tolower(static_cast<unsigned char>(text_[at_])));
    return word_;
  }
  void pass_line() { at_ = std::min(text_.find('\n', at_), text_.size()); }
  const std::string& word() const { return word_; }
  std::size_t line() const { return line_; }

 private:
  static bool is_blank(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }
  std::string_view text_;
  std::string word_;
  std::size_t at_ = 0, line_ = 1;
};

class AsciiStl {
 public:
  explicit AsciiStl(std::string_view text) : words_(text) {}

  StlText read() {
    while (out_.problem.empty() && !words_.next().empty()) {
      if (words_.word() != "solid") want("solid");
      words_.pass_line();  // its name
      while (out_.problem.empty() && words_.next() == "facet") read_facet();
      if (out_.problem.empty() && words_.word() != "endsolid") want("facet or endsolid");
      words_.pass_line();
    }
    return std::move(out_);
  }

 private:
  void want(const std::string& wanted) {
    if (out_.problem.empty())
      out_.problem =
          fmt::format("line {}: wanted {}, found '{}'", words_.line(), wanted, words_.word());
  }
  void expect(const char* word) {
    if (out_.problem.empty() && words_.next() != word) want(word);
  }
  Eigen::Vector3f read_vector() {
    Eigen::Vector3f v = Eigen::Vector3f::Zero();
    for (float& component : v) {
      if (!out_.problem.empty()) break;
      const auto number = finite_number(words_.next());
      if (!number) want("a finite number");
      component = static_cast<float>(number.value_or(0.0));
    }
    return v;
  }
  void pass_normal() {  // some write "nan" where it is undefined
    expect("normal");
    for (int k = 0; k < 3; ++k) words_.next();
  }
  void read_facet() {
    pass_normal();
    expect("outer");
    expect("loop");
    auto& corners = out_.triangles.emplace_back();
    for (Eigen::Vector3f& corner : corners) {
      expect("vertex");
      corner = read_vector();
    }
    expect("endloop");
    expect("endfacet");
  }

  Words words_;
  StlText out_;
};

}  // namespace

StlText stl_triangles(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) return {{}, "it cannot be read"};
  skip_byte_order_mark(in);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  if (is_binary(bytes)) return from_binary(bytes);
  if (Words(bytes).next() == "solid") return AsciiStl(bytes).read();
  return {{},
          "it is neither text that begins with 'solid' nor 84 bytes and 50 for each of its "
          "triangles"};
}

}  // namespace pmr::casefile
