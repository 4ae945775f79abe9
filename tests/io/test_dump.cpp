// Text dumps as LIGGGHTS 3.8.0 writes them (dump ... custom ... id type radius x y z ...).
#include <catch2/catch.hpp>
#include <fstream>

#include "io/dump.hpp"
#include "pmr/base/errors.hpp"
#include "samples.hpp"

using namespace pmr;
using Catch::Contains;

namespace {

std::string frame(int step, const std::string& columns, const std::vector<std::string>& atoms) {
  std::string text = "ITEM: TIMESTEP\n" + std::to_string(step) + "\nITEM: NUMBER OF ATOMS\n" +
                     std::to_string(atoms.size()) +
                     "\nITEM: BOX BOUNDS ff ff ff\n-1 1\n-1 1\n0 1\nITEM: ATOMS " + columns + "\n";
  for (const std::string& atom : atoms) text += atom + "\n";
  return text;
}

struct DumpFile {
  test::Folder folder{"dump"};
  std::filesystem::path path = folder.path() / "bed.dump";
  explicit DumpFile(const std::string& text) {
    std::filesystem::create_directories(folder.path());
    std::ofstream(path) << text;
  }
};

io::Dump read(const std::string& text) { return io::read_dump(DumpFile(text).path); }

// All faults, one a line.
std::string refused(const std::string& text) {
  try {
    read(text);
  } catch (const CaseError& error) {
    return error.what();
  }
  return "accepted";
}

const std::string plain = "id type radius x y z";

}  // namespace

TEST_CASE("The last frame of a dump is read, by id, whatever the order of its columns") {
  const io::Dump dump = read(
      frame(0, plain, {"9 1 0.001 9 9 9"}) +
      frame(500, "vz z fx omegax y type vx radius omegaz x vy id omegay",
            {"6 3 77 7 2 2 4 0.0015 9 0.1e1 5 12 8", "-6 -3 77 -7 -2 1 -4 7.35e-4 -9 -1 -5 4 -8"}));
  CHECK(dump.time_step == 500);
  REQUIRE(dump.atoms.size() == 2);
  CHECK(dump.atoms[0].id == 4);
  const io::DumpAtom& atom = dump.atoms[1];
  CHECK(atom.id == 12);
  CHECK(atom.type == 2);
  CHECK(atom.radius == 0.0015);
  CHECK(atom.position == Vec3(1, 2, 3));
  CHECK(atom.velocity == Vec3(4, 5, 6));
  CHECK(atom.spin == Vec3(7, 8, 9));
}

TEST_CASE("Atoms of a dump without velocities are at rest") {
  const io::Dump dump = read(frame(0, plain, {"1 1 0.001 0 0 0.1"}));
  REQUIRE(dump.atoms.size() == 1);
  CHECK(dump.atoms[0].velocity == Vec3(0, 0, 0));
  CHECK(dump.atoms[0].spin == Vec3(0, 0, 0));
}

TEST_CASE("Scaled, unwrapped and missing columns of a dump are refused by name") {
  CHECK_THAT(refused(frame(0, "id type radius xs ys zs", {"1 1 0.001 0 0 0"})),
             Contains(":9: x: the dump has 'xs', scaled") && Contains("'zs'"));
  CHECK_THAT(refused(frame(0, "id type radius xu yu zu", {"1 1 0.001 0 0 0"})), Contains("'xu'"));
  CHECK_THAT(refused(frame(0, "id type x y z", {"1 1 0 0 0"})),
             Contains("radius: the column is missing"));
  CHECK_THAT(refused(frame(0, plain + " vx vy", {"1 1 0.001 0 0 0 1 1"})),
             Contains("all three components"));
}

TEST_CASE("All bad atoms of a dump are told together, each with its line") {
  const std::string told =
      refused(frame(0, plain,
                    {"1 1 0.001 0 0 nan", "2 1 1.495 0 0 0", "3 1 0.001 0 0", "4 1 -1e-3 0 0 0",
                     "5 1 0.001 0 zero 0", "1 1 0.001 0 0.1 0", "7 1 0.001 0 0.2 0"}));
  CHECK_THAT(told, Contains(":10: z: 'nan' is no finite number"));
  CHECK_THAT(told, Contains(":11: radius: is 1.495 m") && Contains("SI"));
  CHECK_THAT(told, Contains(":12: has 5 columns; the frame has 6"));
  CHECK_THAT(told, Contains(":13: radius: is -1e-3 m"));
  CHECK_THAT(told, Contains(":14: y: 'zero'"));
  CHECK_THAT(refused(frame(0, plain, {"1 1 0.001 0 0 0", "1 1 0.001 0 0.1 0"})),
             Contains(":11: id: atom 1 stands in line 10 already"));
}

TEST_CASE("A dump that is cut or no dump is refused") {
  const std::string whole = frame(7, plain, {"1 1 0.001 0 0 0", "2 1 0.001 0 0.1 0"});
  CHECK_THAT(refused(whole.substr(0, whole.size() - 18)), Contains("ends after 1 of 2 atoms"));
  CHECK_THAT(refused(whole.substr(0, 40)), Contains("frame is cut short"));
  CHECK_THAT(refused("x y z\n1 2 3\n"), Contains("no text dump"));
}

TEST_CASE("A dump's count of atoms is a whole number, and as many follow") {
  const std::string atoms = "1 1 0.001 0 0 0.1\n2 1 0.001 0 0 0.2\n3 1 0.001 0 0 0.3\n";
  const auto with_count = [&](const std::string& count) {
    return "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n" + count +
           "\nITEM: BOX BOUNDS ff ff ff\n-1 1\n-1 1\n0 1\nITEM: ATOMS " + plain + "\n" + atoms;
  };
  CHECK(read(with_count("3 \r")).atoms.size() == 3);
  for (const char* count : {"3.0e0", "3.5", "3 atoms", "-3", ""})
    CHECK_THAT(refused(with_count(count)), Contains(":4: wanted a whole number"));
  CHECK_THAT(refused(with_count("2")),
             Contains(":12: stands behind the 2 atoms that the frame announces: '3 1 0.001"));
  CHECK_THAT(refused(with_count("4")), Contains("ends after 3 of 4 atoms"));
}

TEST_CASE("A dump that declares other units than si is refused") {
  const std::string good = frame(0, plain, {"1 1 0.001 0 0 0.1"});
  CHECK(read("ITEM: UNITS\nsi\n" + good + frame(5, plain, {"1 1 0.001 0 0 0.2"})).time_step == 5);
  CHECK_THAT(refused("ITEM: UNITS\nlj\n" + good), Contains(":2: is in the units 'lj'; wanted"));
}

TEST_CASE("Numbers of a dump are read as those of a CSV file") {
  const io::Dump dump =
      read("\xEF\xBB\xBF" + frame(0, plain, {"1 1 +1.0E-03 -2.0e-02 +1.5E-3 .25 \r"}));
  REQUIRE(dump.atoms.size() == 1);
  CHECK(dump.atoms[0].position == Vec3(-0.02, 0.0015, 0.25));
  for (const char* number : {"0.1mm", "0x1", "+-1", "1e999", "nan"})
    CHECK_THAT(refused(frame(0, plain, {"1 1 0.001 0 0 " + std::string(number)})),
               Contains("' is no finite number"));
  CHECK_THAT(refused(frame(0, plain + " x", {"1 1 0.001 0 0 0.1 0.2"})),
             Contains(":9: x: the column stands twice"));
}
