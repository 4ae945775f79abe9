#include "cli/console.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>

#include "case/nearest.hpp"
#include "cli/shipped_cases.hpp"
#include "cli/start.hpp"
#include "cli/verbs.hpp"
#include "pmr/base/errors.hpp"
#include "version.hpp"

namespace pmr::cli {
namespace {

std::string typed(int argc, char** argv) {
  std::string line = "pmr";
  for (int k = 1; k < argc; ++k) line += std::string(" ") + argv[k];
  return line;
}

// All options of all verbs; `action` is what the parsed verb wants done.
struct Parser {
  CLI::App app{"Particle Mix Reactor: mixing, heat and oxygen release of granular beds"};
  RunOptions run_options;
  RenderOptions render_options;
  SweepOptions sweep_options;
  CalibrateOptions calibrate_options;
  ValidateOptions validate_options;
  std::vector<std::filesystem::path> folders;
  std::filesystem::path html;
  report::ReportWishes wishes;
  bool json = false;
  std::function<int()> action;

  explicit Parser(const std::string& command) {
    app.set_version_flag("--version", std::string("pmr ") + pmr_version + " (" + pmr_git + ")");
    app.require_subcommand(1);
    run_options.command = command;
    add_run();
    add_looks();
    add_sweep();
    add_calibrate();
    add_validate();
  }

  void add_run() {
    auto* run_verb = app.add_subcommand("run", "run a case: the whole chain, then its report");
    run_verb
        ->add_option("CASE", run_options.case_file,
                     "case file (TOML), or the name of a shipped case")
        ->required();
    run_verb->add_option("-o,--output", run_options.folder, "run folder [out/<case>]");
    run_verb->add_option("--set", run_options.sets, "key=value of the case, may be repeated")
        ->expected(1)
        ->take_all();
    add_bed(run_verb);
    add_mechanics(run_verb);
    run_verb->add_option("--threads", run_options.threads, "threads [all cores]")
        ->check(CLI::Range(0, 1024));
    run_verb->callback([this] {
      action = [this] {
        run_options.case_file = find_case(run_options.case_file);
        return run(run_options);
      };
    });

    auto* resume_verb = app.add_subcommand("resume", "go on from a run's last checkpoint");
    resume_verb->add_option("DIR", run_options.folder, "run folder")->required();
    resume_verb->add_option("--threads", run_options.threads, "threads [all cores]")
        ->check(CLI::Range(0, 1024));
    resume_verb->callback([this] {
      action = [this] {
        return resume(run_options.folder, run_options.threads, run_options.command);
      };
    });

    auto* check_verb = app.add_subcommand("check", "validate a case, print derived figures");
    check_verb
        ->add_option("CASE", run_options.case_file,
                     "case file (TOML), or the name of a shipped case")
        ->required();
    check_verb->add_option("--set", run_options.sets, "key=value of the case, may be repeated")
        ->expected(1)
        ->take_all();
    add_bed(check_verb);
    add_mechanics(check_verb);
    check_verb->callback([this] {
      action = [this] { return check(find_case(run_options.case_file), run_options.sets); };
    });
  }

  void add_reference(CLI::App* verb) {
    verb->add_option("--reference", wishes.reference,
                     "CSV of mass ratios to compare the bed with [the case's]");
  }

  void add_bed(CLI::App* verb) {
    verb->add_option_function<std::string>(
        "--bed", [this](const std::string& bed) { run_options.sets.push_back(bed_setting(bed)); },
        "start from the settled bed of a run folder, or from a text dump");
  }

  void add_mechanics(CLI::App* verb) {
    verb->add_flag_callback(
        "--mechanics", [this] { run_options.sets.emplace_back("models.mechanics_only=true"); },
        "particles only: filling and mixing, without heat, gas and reaction");
  }

  void add_sweep() {
    auto* verb = app.add_subcommand("sweep", "a design study: many runs, one table, one report");
    verb->add_option("STUDY", sweep_options.study_file,
                     "study file (TOML), or the name of a shipped study")
        ->required();
    verb->add_option("-o,--output", sweep_options.folder, "study folder [out/<study>]");
    verb->add_option("--set", sweep_options.sets,
                     "key=value: a constant of the study, or a key of every case; repeatable")
        ->expected(1)
        ->take_all();
    add_jobs(verb, sweep_options.jobs);
    verb->add_flag("--plan", sweep_options.only_plan, "only say what would be done");
    verb->callback([this] {
      action = [this] {
        sweep_options.study_file = find_study(sweep_options.study_file);
        return sweep(sweep_options);
      };
    });
  }

  void add_jobs(CLI::App* verb, JobOptions& jobs) {
    verb->add_option("--jobs", jobs.at_once, "runs at once [as many as threads]")
        ->check(CLI::Range(1, 1024));
    verb->add_option("--threads", jobs.threads, "threads of all together [all cores]")
        ->check(CLI::Range(1, 1024));
    verb->add_option("--engine", jobs.engine, "local, or slurm: job arrays by sbatch")
        ->check(CLI::IsMember({"local", "slurm"}));
  }

  void add_calibrate() {
    auto* verb = app.add_subcommand("calibrate", "parameters of cases from tests made in a lab");
    verb->add_option("LAB", calibrate_options.lab_file,
                     "lab file (TOML), or the name of a shipped one")
        ->required();
    verb->add_option("-o,--output", calibrate_options.folder, "folder [out/<lab>]");
    verb->add_option("--set", calibrate_options.sets,
                     "key=value: a constant of the lab file, or a key of every case; repeatable")
        ->expected(1)
        ->take_all();
    verb->add_option("--stage", calibrate_options.last, "the last stage to carry out");
    verb->add_flag("--full", calibrate_options.is_full, "full samples alone, no small ones");
    verb->add_option("--synthetic", calibrate_options.truth,
                     "make a lab file: results of the tests at the parameters of this file");
    add_jobs(verb, calibrate_options.jobs);
    verb->add_flag("--plan", calibrate_options.only_plan, "only say what would be done");
    verb->callback([this] {
      action = [this] {
        calibrate_options.lab_file = find_lab(calibrate_options.lab_file);
        return calibrate(calibrate_options);
      };
    });
  }

  void add_validate() {
    auto* verb = app.add_subcommand("validate", "experiments that others made, run and compared");
    verb->add_option("NAME", validate_options.experiments,
                     "experiment files (TOML), or names of shipped ones [all but the long ones]");
    verb->add_option("-o,--output", validate_options.folder, "folder [out/validation]");
    verb->add_option("--set", validate_options.sets,
                     "key=value: a constant of the experiments, or a key of every case; repeatable")
        ->expected(1)
        ->take_all();
    add_jobs(verb, validate_options.jobs);
    verb->add_flag("--plan", validate_options.only_plan, "only say what would be done");
    verb->callback([this] {
      action = [this] {
        validate_options.experiments = find_experiments(validate_options.experiments);
        return validate(validate_options);
      };
    });
  }

  void add_looks() {
    auto* analyse_verb = app.add_subcommand("analyse", "read the instruments again on a run");
    analyse_verb->add_option("DIR", run_options.folder, "run folder")->required();
    add_reference(analyse_verb);
    analyse_verb->callback(
        [this] { action = [this] { return analyse(run_options.folder, wishes.reference); }; });

    auto* report_verb = app.add_subcommand("report", "one HTML page of one run, or of several");
    report_verb->add_option("DIR", folders, "run folders")->required();
    report_verb->add_option("-o,--output", html, "HTML file [DIR/report.html]");
    add_reference(report_verb);
    report_verb
        ->add_option("--frames", wishes.frame_times,
                     "times in s of the frames of the mixing, such as 0.2,0.4,0.6 [six until rest]")
        ->delimiter(',')
        ->allow_extra_args(false);
    report_verb->callback([this] { action = [this] { return report(folders, html, wishes); }; });

    auto* render_verb = app.add_subcommand("render", "a picture of the bed, cut open");
    render_verb->add_option("DIR", render_options.folder, "run folder")->required();
    render_verb->add_option("--time", render_options.time, "time in s [the last snapshot]");
    render_options.colour = "temperature";
    render_verb->add_option("--colour", render_options.colour, "temperature, delta or species")
        ->check(CLI::IsMember({"temperature", "delta", "species"}));
    render_verb->add_option("-o,--output", render_options.png, "PNG file")->required();
    render_verb->callback([this] { action = [this] { return render(render_options); }; });

    auto* verify_verb = app.add_subcommand("verify", "check physics against laws and publications");
    verify_verb->add_flag("--json", json, "as JSON");
    verify_verb->callback([this] { action = [this] { return verify(json); }; });
  }
};

// A first word that is no verb: CLI11 would answer "pmr frobnicate --help" with the help.
std::string verb_fault(const CLI::App& app, int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return "";
  std::vector<std::string> verbs;
  for (const CLI::App* verb : app.get_subcommands({})) verbs.push_back(verb->get_name());
  if (std::find(verbs.begin(), verbs.end(), argv[1]) != verbs.end()) return "";
  return casefile::unknown_word("verb", argv[1], verbs);
}

}  // namespace

int console(int argc, char** argv) {
  Parser parser(typed(argc, argv));
  if (const std::string fault = verb_fault(parser.app, argc, argv); !fault.empty()) {
    std::fprintf(stderr, "pmr: %s\n", fault.c_str());
    return wrong_input;
  }
  try {
    parser.app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return parser.app.exit(error) == 0 ? done : wrong_input;
  }
  try {
    return parser.action();
  } catch (const CaseError& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return wrong_input;
  } catch (const std::filesystem::filesystem_error& error) {  // of a path that the user named
    std::fprintf(stderr, "%s: %s\n", error.path1().c_str(), error.code().message().c_str());
    return wrong_input;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "pmr: %s\n", error.what());
    return failed;
  }
}

}  // namespace pmr::cli
