#ifndef signorini_tests_mutation_sandbox_h
#define signorini_tests_mutation_sandbox_h

#include <functional>
#include <string>

/** How a task in a process of its own ended. */
struct Outcome
{
  int         exit_code = 0; // when it ended by itself
  int         signal    = 0; // that ended it, or 0
  bool        took_long = false;
  std::string output; // of both streams
};

/** A child process that is limited in time and memory. */
class Sandbox
{
public:
  /** Starts the task, whose result is the exit code. */
  Sandbox(const std::function<int()> &task, const std::string &output_file);

  /** Waits for the end. */
  Outcome
  wait() const;

private:
  std::string output_file;
  int         process;
};

#endif
