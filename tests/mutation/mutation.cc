// Spoilt inputs end in words: mutation PROGRAM_SOURCE SCRATCH N [SEED]
//
// Draws N inputs from the problems, meshes, interface problems and checkpoints
// of the checkout, spoils each, and checks or starts it in a process of its
// own. None may crash, hang, end with a success that holds a NaN, with an exit
// code that does not exist, or with a message that does not say where. What
// fails is kept in SCRATCH/failed.
#include <signorini/run/error_report.h>
#include <signorini/run/run.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>

#include "mutator.h"
#include "sandbox.h"

namespace
{
  namespace fs = std::filesystem;
  using namespace Signorini;

  enum class Kind
  {
    problem,
    mesh,
    interface,
    checkpoint
  };

  /** What is spoilt. */
  struct Source
  {
    Kind     kind;
    fs::path file; // in the copy of the checkout
    unsigned weight;
  };

  /** One spoilt input and what is done with it. */
  struct Input
  {
    const Source *source;
    unsigned int  number;
    std::string   text;
    bool          is_run; // and not only checked
    fs::path      prm;    // what the program is given
    fs::path      folder; // of its results
  };

  std::string
  content(const fs::path &file)
  {
    std::ifstream      stream(file, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
  }

  void
  write(const fs::path &file, const std::string &text)
  {
    std::ofstream(file, std::ios::binary) << text;
  }

  int
  solve(const std::string &file, const RunOptions &options, const Kind kind)
  {
    try
      {
        if (kind == Kind::interface)
          solve_interface(file, std::cout);
        else
          run_problem(file, options);
        return done;
      }
    catch (...)
      {
        return report_error(file, std::cerr);
      }
  }

  std::string
  problem_of_mesh(const fs::path &mesh)
  {
    const bool is_solid = mesh.string().find("brick") != std::string::npos;
    return std::string("set Formulation = ") +
           (is_solid ? "three dimensional" : "plane strain") +
           "\nset Bodies = b\nsubsection Body b\n  set Mesh = file\n"
           "  subsection File\n    set Name = " +
           mesh.filename().string() + "\n  end\nend\n";
  }

  /** The problems are small ones: each has to be solved in a blink. */
  std::vector<Source>
  sources(const fs::path &copy)
  {
    std::vector<Source> list;
    for (const char *const name : {"tests/errors/common/beam.prm",
                                   "tests/errors/common/punch.prm",
                                   "tests/errors/common/two_blocks.prm",
                                   "tests/verification/incline.prm",
                                   "tests/verification/stick_slip.prm",
                                   "tests/verification/patch_test.prm",
                                   "tests/verification/uniaxial_stretch.prm",
                                   "tests/verification/two_materials.prm",
                                   "tests/verification/rayleigh_damping.prm",
                                   "tests/verification/box_on_box.prm",
                                   "tests/verification/touch_on_a_step.prm",
                                   "tests/verification/pressed_block.prm"})
      list.push_back({Kind::problem, copy / name, 8});
    for (const char *const name : {"tests/unit/meshes/plate_41.msh",
                                   "tests/unit/meshes/plate_22.msh",
                                   "tests/unit/meshes/brick.msh",
                                   "tests/unit/meshes/square.inp",
                                   "tests/unit/meshes/plate_gmsh.inp",
                                   "tests/unit/meshes/bricks.inp"})
      list.push_back({Kind::mesh, copy / name, 4});
    return list;
  }

  /** A run that leaves an interface problem and a checkpoint. */
  void
  make_files(const fs::path &copy, std::vector<Source> &list)
  {
    const fs::path prm = copy / "tests/errors/common/two_blocks.prm";
    RunOptions     options;
    options.output_directory = (copy / "first").string();
    options.max_steps        = 1;
    options.overrides        = {"Output/Interface problems at=1e-12"};
    const Outcome outcome =
      Sandbox([&] { return solve(prm.string(), options, Kind::problem); },
              (copy / "first.log").string())
        .wait();
    const fs::path folder = copy / "first/two_blocks";
    if (outcome.exit_code != 0 || outcome.signal != 0)
      throw std::runtime_error("The first run failed:\n" + outcome.output);
    list.push_back({Kind::interface, folder / "interface_1.txt", 12});
    list.push_back({Kind::checkpoint, folder / "last.checkpoint", 12});
    for (const Source &source : list)
      if (!fs::exists(source.file))
        throw std::runtime_error(source.file.string() + " is missing.");
  }

  const Source &
  draw(const std::vector<Source> &list, Mutator &mutator)
  {
    unsigned int sum = 0;
    for (const Source &source : list)
      sum += source.weight;
    unsigned int at = mutator.choose(sum);
    for (const Source &source : list)
      {
        if (at < source.weight)
          return source;
        at -= source.weight;
      }
    return list.front();
  }

  Input
  make_input(const unsigned int         number,
             const std::vector<Source> &list,
             const fs::path            &copy,
             Mutator                   &mutator)
  {
    Input input;
    input.source = &draw(list, mutator);
    input.number = number;
    input.text   = mutator.mutate(content(input.source->file));
    input.is_run = input.source->kind == Kind::checkpoint ||
                   (input.source->kind == Kind::problem && number % 3 == 0);
    const std::string name = "mutant_" + std::to_string(number);
    const fs::path    home = input.source->file.parent_path();
    input.folder           = copy / "results" / name;
    switch (input.source->kind)
      {
        case Kind::problem:
          input.prm = home / (name + ".prm");
          write(input.prm, input.text);
          break;
        case Kind::mesh:
          {
            const fs::path mesh =
              home / (input.source->file.stem().string() + name +
                      input.source->file.extension().string());
            input.prm = home / (name + ".prm");
            write(mesh, input.text);
            write(input.prm, problem_of_mesh(mesh));
            break;
          }
        case Kind::interface:
          input.prm = home / (name + ".txt");
          write(input.prm, input.text);
          break;
        case Kind::checkpoint:
          input.prm = copy / "tests/errors/common/two_blocks.prm";
          fs::create_directories(input.folder.parent_path());
          fs::copy(home, input.folder);
          write(input.folder / input.source->file.filename(), input.text);
      }
    return input;
  }

  Sandbox
  start(const Input &input, const fs::path &log)
  {
    RunOptions options;
    options.check_only       = !input.is_run;
    options.output_directory = input.folder.parent_path().string();
    if (input.source->kind == Kind::checkpoint)
      options.resume = input.folder.string();
    if (input.is_run)
      options.max_steps = 1;
    return Sandbox(
      [=] { return solve(input.prm.string(), options, input.source->kind); },
      log.string());
  }

  /** Whether all numbers of the history are finite. */
  bool
  is_finite(const fs::path &history)
  {
    std::ifstream stream(history);
    std::string   line;
    std::getline(stream, line); // the names
    while (std::getline(stream, line))
      {
        std::istringstream cells(line);
        for (std::string cell; std::getline(cells, cell, ',');)
          if (!cell.empty() &&
              !std::isfinite(std::strtod(cell.c_str(), nullptr)))
            return false;
      }
    return true;
  }

  /** What is wrong with the end of an input, or nothing. */
  std::string
  judge(const Input &input, const Outcome &outcome)
  {
    if (outcome.took_long)
      return "hangs";
    if (outcome.signal != 0)
      return "crashes with signal " + std::to_string(outcome.signal);
    const int code = outcome.exit_code;
    if (code == done)
      return input.is_run && !is_finite(input.folder / "history.csv") ?
               "succeeds with a NaN" :
               "";
    if (code != wrong_input && code != computation_failed &&
        code != expected_results_missed)
      return "exit code " + std::to_string(code);
    for (const char *const word : {"std::",
                                   "dealii::",
                                   "boost::",
                                   "mu::",
                                   "terminate",
                                   "An error occurred in line"})
      if (outcome.output.find(word) != std::string::npos)
        return std::string("the message speaks C++: ") + word;
    if (!input.is_run && code == computation_failed &&
        outcome.output.find("Out of memory") == std::string::npos &&
        input.source->kind != Kind::interface)
      return "a check fails instead of refusing the input";
    const bool says_where =
      outcome.output.find(input.prm.stem().string()) != std::string::npos ||
      outcome.output.find("--resume") != std::string::npos;
    return code == wrong_input && !says_where ? "does not say where" : "";
  }

  void
  keep(const Input &input, const Outcome &outcome, const fs::path &folder)
  {
    fs::create_directories(folder);
    const std::string name = std::to_string(input.number) + "_" +
                             input.source->file.filename().string();
    write(folder / name, input.text);
    write(folder / (name + ".log"), outcome.output);
  }

  void
  remove_files(const Input &input)
  {
    fs::remove_all(input.folder);
    if (input.source->kind == Kind::mesh)
      fs::remove(input.prm.parent_path() /
                 (input.source->file.stem().string() +
                  input.prm.stem().string() +
                  input.source->file.extension().string()));
    if (input.source->kind != Kind::checkpoint)
      fs::remove(input.prm);
  }

  /** The number of inputs that ended wrongly. */
  unsigned int
  run(const fs::path    &root,
      const fs::path    &scratch,
      const unsigned int n_inputs,
      const unsigned int seed)
  {
    fs::remove_all(scratch);
    const fs::path copy = scratch / "copy";
    for (const char *const folder :
         {"tests/errors", "tests/verification", "tests/unit/meshes", "prm"})
      {
        fs::create_directories((copy / folder).parent_path());
        fs::copy(root / folder, copy / folder, fs::copy_options::recursive);
      }
    std::vector<Source> list = sources(copy);
    make_files(copy, list);
    std::vector<std::string> pool;
    for (const Source &source : list)
      if (source.kind == Kind::problem)
        pool.push_back(content(source.file));

    Mutator                         mutator(seed, pool);
    std::map<std::string, unsigned> n_codes;
    unsigned int                    n_failed       = 0;
    constexpr unsigned int          n_side_by_side = 2;
    for (unsigned int first = 0; first < n_inputs; first += n_side_by_side)
      {
        std::vector<Input>   inputs;
        std::vector<Sandbox> sandboxes;
        for (unsigned int i = first;
             i < std::min(first + n_side_by_side, n_inputs);
             ++i)
          {
            inputs.push_back(make_input(i, list, copy, mutator));
            sandboxes.push_back(
              start(inputs.back(),
                    scratch / ("log_" + std::to_string(i - first))));
          }
        for (std::size_t i = 0; i < inputs.size(); ++i)
          {
            const Outcome     outcome = sandboxes[i].wait();
            const std::string fault   = judge(inputs[i], outcome);
            ++n_codes[fault.empty() ? std::to_string(outcome.exit_code) :
                                      fault];
            if (!fault.empty())
              {
                ++n_failed;
                keep(inputs[i], outcome, scratch / "failed");
                std::cout << inputs[i].number << " of "
                          << inputs[i].source->file.filename().string() << ": "
                          << fault << std::endl;
              }
            remove_files(inputs[i]);
          }
      }
    for (const auto &[end, n] : n_codes)
      std::cout << n << " x " << end << '\n';
    return n_failed;
  }
} // namespace



int
main(int argc, char **argv)
{
  if (argc < 4)
    {
      std::cerr << "usage: mutation CHECKOUT SCRATCH N [SEED]\n";
      return 2;
    }
  try
    {
      const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
      const unsigned int                             n_failed = run(argv[1],
                                        argv[2],
                                        std::stoul(argv[3]),
                                        argc > 4 ? std::stoul(argv[4]) : 1);
      std::cout << n_failed << " of " << argv[3] << " inputs ended wrongly"
                << std::endl;
      return n_failed == 0 ? 0 : 1;
    }
  catch (const std::exception &error)
    {
      std::cerr << error.what() << std::endl;
      return 1;
    }
}
