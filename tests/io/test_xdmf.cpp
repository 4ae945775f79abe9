// run.xdmf must be what readers of XDMF expect: well-formed, and true about run.h5.
#include <catch2/catch.hpp>
#include <fstream>
#include <regex>

#include "io/hdf5.hpp"
#include "samples.hpp"

using namespace pmr;

namespace {

std::string text_of(const std::filesystem::path& path) {
  std::ifstream in(path);
  return {std::istreambuf_iterator<char>(in), {}};
}

// Every tag closed in the order of opening, one root.
bool is_well_formed(const std::string& xml) {
  const std::regex tag(R"(<(/?)(\w+)((?:\s+\w+="[^"<&]*")*)\s*(/?)>)");
  std::string text = xml.substr(xml.find("?>") + 2);
  std::vector<std::string> open;
  std::size_t roots = 0;
  std::string rest;
  auto last = text.cbegin();
  for (std::sregex_iterator it(text.begin(), text.end(), tag), end; it != end; ++it) {
    rest.append(last, text.cbegin() + it->position());
    last = text.cbegin() + it->position() + it->length();
    if ((*it)[1].length() > 0) {
      if (open.empty() || open.back() != (*it)[2]) return false;
      open.pop_back();
    } else {
      roots += open.empty();
      if ((*it)[4].length() == 0) open.push_back((*it)[2]);
    }
  }
  return open.empty() && roots == 1 && rest.find_first_of("<>&") == std::string::npos;
}

std::string sample_text(const std::filesystem::path& dir) {
  io::create_run(dir, test::header());
  const std::vector<io::Snapshot> three{test::random_snapshot(-0.25, 7),
                                        test::random_snapshot(0.0, 0),
                                        test::random_snapshot(0.1, 9)};
  io::append_run(dir, test::rows(0.0, 2), three);
  return text_of(dir / "run.xdmf");
}

}  // namespace

TEST_CASE("run.xdmf is well-formed XML and lists the snapshots that hold particles") {
  const test::Folder folder("xdmf");
  const std::string text = sample_text(folder.path());
  CHECK(is_well_formed(text));
  CHECK_FALSE(is_well_formed(text + "</Grid>"));
  const std::regex time(R"re(<Time Value="([^"]*)"/>)re");
  std::vector<std::string> times;
  for (std::sregex_iterator it(text.begin(), text.end(), time), end; it != end; ++it)
    times.push_back((*it)[1]);
  CHECK(times == std::vector<std::string>{"-0.25", "0.1"});
  for (const char* field : {"radius", "temperature", "delta", "species", "velocity", "id"})
    CHECK(text.find("Attribute Name=\"" + std::string(field) + "\"") != std::string::npos);
}

TEST_CASE("Datasets that run.xdmf refers to exist with the sizes it says") {
  const test::Folder folder("xdmf_sizes");
  const std::string text = sample_text(folder.path());
  const io::H5File run = io::H5File::open(folder.path() / "run.h5");
  const std::regex item(
      R"re(<DataItem Dimensions="(\d+)( 3)?" NumberType="(\w+)" Precision="(\d)" )re"
      R"re(Format="HDF">run\.h5:([^<]*)<)re");
  std::size_t count = 0;
  for (std::sregex_iterator it(text.begin(), text.end(), item), end; it != end; ++it, ++count) {
    const std::string path = (*it)[5];
    INFO(path);
    REQUIRE(run.has(path));
    CHECK(run.shape(path).rows == std::stoul((*it)[1]));
    CHECK(run.shape(path).width == ((*it)[2].length() > 0 ? 3 : 1));
  }
  CHECK(count == 2UL * 9);  // vertices, position and seven attributes, two snapshots with particles
}

// ParaView's Xdmf3 readers take cells from a dataset alone: without one nothing is drawn.
TEST_CASE("Every particle is a cell of its own, which a dataset names") {
  const test::Folder folder("xdmf_cells");
  const std::string text = sample_text(folder.path());
  const io::H5File run = io::H5File::open(folder.path() / "run.h5");
  const std::regex topology(
      R"re(<Topology TopologyType="Polyvertex" NumberOfElements="(\d+)" NodesPerElement="1">)re"
      R"re(<DataItem[^>]*>run\.h5:([^<]*)</DataItem></Topology>)re");
  std::vector<std::size_t> counts;
  for (std::sregex_iterator it(text.begin(), text.end(), topology), end; it != end; ++it) {
    const auto vertices = run.read<std::uint32_t>((*it)[2]);
    REQUIRE(vertices.size() == std::stoul((*it)[1]));
    for (std::uint32_t k = 0; k < vertices.size(); ++k) CHECK(vertices[k] == k);
    counts.push_back(vertices.size());
  }
  CHECK(counts == std::vector<std::size_t>{7, 9});
}

TEST_CASE("An empty run has an empty collection") {
  const test::Folder folder("xdmf_empty");
  io::create_run(folder.path(), test::header());
  const std::string text = text_of(folder.path() / "run.xdmf");
  CHECK(is_well_formed(text));
  CHECK(text.find("Polyvertex") == std::string::npos);
}
