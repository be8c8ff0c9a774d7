#include <signorini/run/interruption.h>

#include <unistd.h>

#include <csignal>

namespace Signorini
{
  namespace
  {
    volatile std::sig_atomic_t signal_came = 0;
  }



  // In a signal handler only functions such as write() and signal() are safe.
  extern "C" void
  signorini_handle_signal(const int /*signal_number*/)
  {
    signal_came              = 1;
    static const char text[] = "\nStopping after this step. Press Ctrl-C again "
                               "to stop at once.\n";
    const auto        ignored = write(STDERR_FILENO, text, sizeof(text) - 1);
    static_cast<void>(ignored);
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
  }



  void
  catch_interruptions()
  {
    signal_came = 0;
    std::signal(SIGINT, signorini_handle_signal);
    std::signal(SIGTERM, signorini_handle_signal);
    std::signal(SIGXFSZ, SIG_IGN);
  }



  bool
  is_interrupted()
  {
    return signal_came != 0;
  }
} // namespace Signorini
