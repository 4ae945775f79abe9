// STL files as CAD programs write them, and what is no STL file.
#include <catch2/catch.hpp>
#include <cstdint>
#include <cstring>
#include <fstream>

#include "case/stl.hpp"
#include "helpers.hpp"

using namespace pmr;
using Catch::Contains;

namespace {

casefile::StlFile read_text(const std::string& bytes) {
  const std::string file = test::temporary("pmr_test_text.stl");
  std::ofstream(file, std::ios::binary) << bytes;
  casefile::StlFile stl = casefile::read_stl(file, 1e-3);
  std::filesystem::remove(file);
  return stl;
}

std::string problem_of(const std::string& bytes) {
  const casefile::StlFile stl = read_text(bytes);
  return stl.problems.empty() ? "" : stl.problems.front();
}

const std::string facet =
    " facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n   vertex 10 0 +0.0\n"
    "   vertex 0 1.0E+01 0\n  endloop\n endfacet\n";

std::string binary(std::uint32_t announced, std::size_t triangles) {
  std::string bytes(80, ' ');
  bytes.replace(0, 5, "solid");  // some programs begin binary files so
  bytes.append(reinterpret_cast<const char*>(&announced), 4);
  const float numbers[12] = {0, 0, 1, 0, 0, 0, 10, 0, 0, 0, 10, 0};
  for (std::size_t k = 0; k < triangles; ++k) {
    bytes.append(reinterpret_cast<const char*>(numbers), sizeof numbers);
    bytes.append(2, '\0');
  }
  return bytes;
}

}  // namespace

TEST_CASE("text in small and capital letters, behind blank lines, with CRLF, and binary are one") {
  std::string capitals = "SOLID PART\n" + facet + "ENDSOLID\n";
  for (char& c : capitals) c = static_cast<char>(std::toupper(c));
  std::string windows;
  for (const char c : "solid part\n" + facet + "endsolid part\n")
    windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
  for (const std::string& bytes :
       {"solid\n" + facet + "endsolid\n", capitals, "\n\n\t  solid part 2\n" + facet + "endsolid",
        "\xEF\xBB\xBF" + windows, binary(1, 1)}) {
    const casefile::StlFile stl = read_text(bytes);
    REQUIRE(stl.problems.empty());
    REQUIRE(stl.triangles.size() == 1);
    CHECK(stl.triangles[0][1].isApprox(Vec3(0.01, 0, 0), 1e-7));
    CHECK(stl.triangles[0][2].isApprox(Vec3(0, 0.01, 0), 1e-7));
  }
}

TEST_CASE("several solids in one file are one mesh") {
  CHECK(read_text("solid a\n" + facet + "endsolid a\nsolid b\n" + facet + facet + "endsolid b\n")
            .triangles.size() == 3);
}

TEST_CASE("a text that is cut or holds no number is refused with its line") {
  const std::string whole = "solid a\n" + facet + "endsolid a\n";
  CHECK_THAT(problem_of(whole.substr(0, whole.size() - 21)), Contains("wanted endfacet, found ''"));
  CHECK_THAT(problem_of(test::replaced(whole, "10 0 +0.0", "10 0 +0.0mm")),
             Contains("line 5: wanted a finite number, found '+0.0mm'"));
  CHECK_THAT(problem_of(test::replaced(whole, "outer", "inner")),
             Contains("line 3: wanted outer, found 'inner'"));
  CHECK_THAT(problem_of("solid a\nendsolid a\n"), Contains("holds no triangle"));
}

TEST_CASE("a binary file that is cut, or longer than announced, is refused") {
  CHECK_THAT(problem_of(binary(2, 1)), Contains("is no STL file"));
  CHECK_THAT(problem_of(binary(1, 1).replace(0, 5, "begin") + "x"), Contains("is no STL file"));
}
