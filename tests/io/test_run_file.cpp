// run.h5: what goes in comes out; a kill at any moment leaves the last complete file.
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <fstream>
#include <set>

#include "io/hdf5.hpp"
#include "io/series.hpp"
#include "pmr/base/errors.hpp"
#include "pmr/base/storage_error.hpp"
#include "samples.hpp"

using namespace pmr;
using Catch::Matchers::Contains;

namespace {

io::Series joined(io::Series a, const io::Series& b) {
  for (std::size_t c = 0; c < a.columns.size(); ++c)
    a.columns[c].values.insert(a.columns[c].values.end(), b.columns[c].values.begin(),
                               b.columns[c].values.end());
  return a;
}

void require_equal(const io::Series& a, const io::Series& b) {
  REQUIRE(a.columns.size() == b.columns.size());
  for (std::size_t c = 0; c < a.columns.size(); ++c) {
    CHECK(a.columns[c].name == b.columns[c].name);
    CHECK(a.columns[c].unit == b.columns[c].unit);
    CHECK(a.columns[c].values == b.columns[c].values);
  }
}

std::string slurp(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// Calls visit(path) for every dataset below a group.
template <class Visitor>
void walk(const io::H5File& file, const std::string& group, const Visitor& visit) {
  for (const std::string& name : file.children(group)) {
    const std::string path = (group == "/" ? "" : group) + "/" + name;
    if (file.is_group(path))
      walk(file, path, visit);
    else
      visit(path);
  }
}

std::size_t datasets_with_unit(const std::filesystem::path& path) {
  const io::H5File file = io::H5File::open(path);
  std::size_t count = 0;
  walk(file, "/", [&](const std::string& dataset) {
    INFO(dataset);
    REQUIRE(file.has_attribute(dataset, "unit"));
    CHECK_FALSE(file.text_attribute(dataset, "unit").empty());
    ++count;
  });
  return count;
}

// Appends for ever in a child process until it is killed.
pid_t start_endless_writer(const std::filesystem::path& dir) {
  const pid_t child = ::fork();
  if (child != 0) return child;
  for (double t = 0.0;; t += 10.0) {
    const std::vector<io::Snapshot> one{test::random_snapshot(t, 3000)};
    io::append_run(dir, test::rows(t, 10), one);
  }
}

}  // namespace

TEST_CASE("The header of a run comes back as written") {
  const test::Folder folder("header");
  io::create_run(folder.path(), test::header());
  const io::RunHeader back = io::read_header(folder.path());
  CHECK(back.case_text == test::header().case_text);
  CHECK(back.provenance == test::header().provenance);
  CHECK(back.species == test::header().species);
  CHECK(back.patches == test::header().patches);
  CHECK(io::read_series(folder.path()).columns.empty());
  CHECK(io::snapshot_times(folder.path()).empty());
}

TEST_CASE("A run without case text, species or patches comes back empty") {
  const test::Folder folder("empty");
  io::create_run(folder.path(), {});
  const io::RunHeader back = io::read_header(folder.path());
  CHECK(back.case_text.empty());
  CHECK(back.provenance.empty());
  CHECK(back.species.empty());
  CHECK(back.patches.empty());
}

TEST_CASE("A snapshot keeps all bits but of velocity, spin and enthalpy, which keep 24") {
  const test::Folder folder("snapshot");
  io::create_run(folder.path(), test::header());
  const std::vector<io::Snapshot> written{test::random_snapshot(-0.5, 4000),
                                          test::random_snapshot(0.25, 0)};
  io::append_run(folder.path(), {}, written);
  CHECK(io::snapshot_times(folder.path()) == std::vector<double>{-0.5, 0.25});
  const io::Snapshot back = io::read_snapshot(folder.path(), 0);
  const Particles& a = back.particles;
  const Particles& b = written[0].particles;
  CHECK((back.time == -0.5 && back.phase == Phase::mix));
  CHECK(back.wall_temperature == written[0].wall_temperature);
  CHECK((a.id == b.id && a.species == b.species && a.radius == b.radius && a.mass == b.mass));
  CHECK((a.position == b.position && a.formula_units == b.formula_units && a.delta == b.delta));
  CHECK(a.temperature == b.temperature);
  REQUIRE(a.velocity.size() == b.velocity.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    CHECK(a.velocity[i] == b.velocity[i].cast<float>().cast<double>());
    CHECK(a.spin[i] == b.spin[i].cast<float>().cast<double>());
    CHECK(a.enthalpy[i] == static_cast<double>(static_cast<float>(b.enthalpy[i])));
  }
  CHECK(a.force == std::vector<Vec3>(b.size(), Vec3(Vec3::Zero())));
  CHECK(io::read_snapshot(folder.path(), 1).particles.size() == 0);
  CHECK_THROWS_AS(io::read_snapshot(folder.path(), 2), CaseError);
}

TEST_CASE("Appending in several calls gives what one call gives") {
  const test::Folder whole("whole"), parts("parts");
  const std::vector<io::Snapshot> snapshots{test::random_snapshot(1.0, 50),
                                            test::random_snapshot(2.0, 60)};
  io::create_run(whole.path(), test::header());
  io::append_run(whole.path(), joined(test::rows(0.0, 700), test::rows(700.0, 900)), snapshots);
  io::create_run(parts.path(), test::header());
  io::append_run(parts.path(), test::rows(0.0, 700), {snapshots.data(), 1});
  io::append_run(parts.path(), test::rows(700.0, 900), {});
  io::append_run(parts.path(), {}, {snapshots.data() + 1, 1});
  require_equal(io::read_series(parts.path()), io::read_series(whole.path()));
  CHECK(io::snapshot_times(parts.path()) == io::snapshot_times(whole.path()));
  CHECK(io::read_snapshot(parts.path(), 1).particles.position == snapshots[1].particles.position);
  CHECK(slurp(parts.path() / "run.xdmf") == slurp(whole.path() / "run.xdmf"));
}

TEST_CASE("Dropping what came later and appending again gives the undisturbed run") {
  const test::Folder folder("drop");
  io::create_run(folder.path(), test::header());
  const std::vector<io::Snapshot> all{test::random_snapshot(1.0, 5), test::random_snapshot(4.0, 6),
                                      test::random_snapshot(8.0, 7)};
  io::append_run(folder.path(), test::rows(0.0, 10), all);
  io::drop_after(folder.path(), 4.0);
  require_equal(io::read_series(folder.path()), test::rows(0.0, 5));
  CHECK(io::snapshot_times(folder.path()) == std::vector<double>{1.0, 4.0});
  io::append_run(folder.path(), test::rows(5.0, 5), {all.data() + 2, 1});
  require_equal(io::read_series(folder.path()), test::rows(0.0, 10));
  CHECK(io::read_snapshot(folder.path(), 2).particles.id == all[2].particles.id);
  io::drop_after(folder.path(), -1.0);
  CHECK(io::read_series(folder.path()).rows() == 0);
  CHECK(io::snapshot_times(folder.path()).empty());
}

TEST_CASE("Rows with other columns than the first append's break a promise") {
  const test::Folder folder("columns");
  io::create_run(folder.path(), test::header());
  io::append_run(folder.path(), test::rows(0.0, 2), {});
  io::Series other = test::rows(2.0, 1);
  other.columns[1].name = "renamed";
  CHECK_THROWS_AS(io::append_run(folder.path(), other, {}), std::logic_error);
  require_equal(io::read_series(folder.path()), test::rows(0.0, 2));
  CHECK_FALSE(std::filesystem::exists(folder.path() / "run.h5.tmp"));
}

TEST_CASE("Every dataset of a run and of a checkpoint bears its unit") {
  const test::Folder folder("units");
  io::create_run(folder.path(), test::header());
  const std::vector<io::Snapshot> one{test::random_snapshot(0.0, 3)};
  io::append_run(folder.path(), test::rows(0.0, 1), one);
  io::save_checkpoint(folder.path(), test::random_state(3, 1));
  CHECK(datasets_with_unit(folder.path() / "run.h5") ==
        20);  // 4 lists, 3 columns, 12 fields, vertices
  CHECK(datasets_with_unit(folder.path() / "checkpoint.h5") > 60);
  const io::H5File file = io::H5File::open(folder.path() / "run.h5");
  CHECK(file.text_attribute("/snapshots/00000/velocity", "unit") == "m s-1");
  CHECK(file.text_attribute("/series/temperature_mean.SrFeO3", "unit") == "K");
}

TEST_CASE("Equal runs give equal files") {
  const test::Folder a("equal_a"), b("equal_b");
  for (const auto* folder : {&a, &b}) {
    io::create_run(folder->path(), test::header());
    const std::vector<io::Snapshot> one{test::random_snapshot(0.0, 100)};
    io::append_run(folder->path(), test::rows(0.0, 5), one);
    io::save_checkpoint(folder->path(), test::random_state(100, 1));
  }
  CHECK(slurp(a.path() / "run.h5") == slurp(b.path() / "run.h5"));
  CHECK(slurp(a.path() / "checkpoint.h5") == slurp(b.path() / "checkpoint.h5"));
}

TEST_CASE("A temporary left by a killed run disturbs nobody and goes") {
  const test::Folder folder("leftover");
  io::create_run(folder.path(), test::header());
  io::append_run(folder.path(), test::rows(0.0, 3), {});
  std::filesystem::copy_file(folder.path() / "run.h5", folder.path() / "run.h5.tmp");
  std::filesystem::resize_file(folder.path() / "run.h5.tmp", 700);
  require_equal(io::read_series(folder.path()), test::rows(0.0, 3));
  io::append_run(folder.path(), test::rows(3.0, 1), {});
  require_equal(io::read_series(folder.path()), test::rows(0.0, 4));
  CHECK_FALSE(std::filesystem::exists(folder.path() / "run.h5.tmp"));
}

TEST_CASE("A writer killed at any moment leaves a whole file") {
  for (const useconds_t wait : {3000, 11000, 23000, 37000, 54000, 80000}) {  // [us]
    const test::Folder folder("killed");
    io::create_run(folder.path(), test::header());
    const pid_t child = start_endless_writer(folder.path());
    ::usleep(wait);
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    const io::Series series = io::read_series(folder.path());
    CHECK(series.rows() % 10 == 0);
    CHECK(io::snapshot_times(folder.path()).size() == series.rows() / 10);
    if (series.rows() > 0) io::read_snapshot(folder.path(), series.rows() / 10 - 1);
    io::append_run(folder.path(), test::rows(1e6, 10), {});
  }
}

TEST_CASE("A new run in an old folder takes the old checkpoint away") {
  const test::Folder folder("again");
  io::create_run(folder.path(), test::header());
  io::save_checkpoint(folder.path(), State{});
  io::create_run(folder.path(), test::header());
  CHECK_FALSE(io::has_checkpoint(folder.path()));
}

TEST_CASE("A folder that cannot be written is named and left as it was") {
  const test::Folder folder("blocked");
  std::filesystem::create_directories(folder.path());
  std::ofstream(folder.path() / "file") << "not a folder";
  CHECK_THROWS_AS(io::create_run(folder.path() / "file" / "run", test::header()), StorageError);
  CHECK_THROWS_WITH(io::create_run(folder.path() / "file", test::header()),
                    Contains((folder.path() / "file").string()));
  CHECK_THROWS_WITH(io::save_checkpoint(folder.path() / "absent", State{}),
                    Contains("checkpoint.h5: cannot be written"));
  CHECK(slurp(folder.path() / "file") == "not a folder");
}

TEST_CASE("Foreign, cut and future files are refused with their name and what was wanted") {
  const test::Folder folder("foreign");
  CHECK_THROWS_WITH(io::read_series(folder.path()), Contains("run.h5: no such file"));
  io::create_run(folder.path(), test::header());
  const auto path = folder.path() / "run.h5";
  {
    io::H5File file = io::H5File::modify(path);
    io::set_format(file, "pmr-run", 3);
    file.close();
  }
  CHECK_THROWS_WITH(io::read_header(folder.path()),
                    Contains("run.h5: pmr-run version 2 wanted, found pmr-run version 3"));
  CHECK_THROWS_AS(io::append_run(folder.path(), test::rows(0.0, 1), {}), StorageError);
  std::filesystem::resize_file(path, std::filesystem::file_size(path) / 2);
  CHECK_THROWS_WITH(io::read_header(folder.path()), Contains("run.h5: an HDF5 file of pmr wanted"));
  std::ofstream(path) << "no HDF5";
  CHECK_THROWS_WITH(io::read_header(folder.path()), Contains("foreign or damaged"));
  io::H5File::create(path).close();
  CHECK_THROWS_WITH(io::read_header(folder.path()), Contains("found an HDF5 file without format"));
}

TEST_CASE("A series is asked by name") {
  const io::Series series = test::rows(0.0, 3);
  CHECK(series.rows() == 3);
  CHECK(series.has("zeta"));
  CHECK_FALSE(series.has("eta"));
  CHECK(series.values("time") == std::vector<double>{0.0, 1.0, 2.0});
  CHECK_THROWS_AS(series.values("eta"), CaseError);
}

TEST_CASE("CSV names units and gives back the same doubles") {
  const test::Folder folder("csv");
  std::filesystem::create_directories(folder.path());
  const io::Series series{{{"time", "s", {0.1, 1e-300}}, {"w", "1", {1.0 / 3.0, -0.0}}}};
  io::write_csv(folder.path() / "a.csv", series);
  CHECK(slurp(folder.path() / "a.csv") == "time [s],w [1]\n0.1,0.3333333333333333\n1e-300,-0\n");
}
