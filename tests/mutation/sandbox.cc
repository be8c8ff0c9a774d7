#include "sandbox.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <exception>
#include <fstream>
#include <iostream>
#include <sstream>

namespace
{
  constexpr rlim_t       most_seconds = 10; // of the processor
  constexpr unsigned int most_waiting = 60; // on a busy machine, s
  constexpr rlim_t       most_memory  = 4'000'000'000;

  void
  limit(const __rlimit_resource resource, const rlim_t value)
  {
    const rlimit both = {value, value};
    setrlimit(resource, &both);
  }
} // namespace



Sandbox::Sandbox(const std::function<int()> &task,
                 const std::string          &output_file)
  : output_file(output_file)
{
  std::cout << std::flush;
  process = fork();
  if (process != 0)
    return;
  limit(RLIMIT_CPU, most_seconds);
  limit(RLIMIT_AS, most_memory);
  limit(RLIMIT_CORE, 0);
  alarm(most_waiting);
  const int file =
    open(output_file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  dup2(file, STDOUT_FILENO);
  dup2(file, STDERR_FILENO);
  const int code = task();
  std::cout << std::flush;
  std::cerr << std::flush;
  std::fflush(nullptr);
  _exit(code);
}



Outcome
Sandbox::wait() const
{
  Outcome outcome;
  int     status = 0;
  waitpid(process, &status, 0);
  if (WIFSIGNALED(status))
    {
      outcome.signal    = WTERMSIG(status);
      outcome.took_long = outcome.signal == SIGXCPU ||
                          outcome.signal == SIGALRM ||
                          outcome.signal == SIGKILL;
    }
  else
    outcome.exit_code = WEXITSTATUS(status);
  std::ifstream      file(output_file);
  std::ostringstream text;
  text << file.rdbuf();
  outcome.output = text.str();
  return outcome;
}
