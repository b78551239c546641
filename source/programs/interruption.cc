// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/programs/interruption.h>

#include <climits>
#include <csignal>
#include <cstring>
#include <unistd.h>
#include <vector>

namespace ringmotor
{
  namespace
  {
    // A signal may come at any time: the message is kept ready, in memory that does not move.
    constexpr std::size_t longest = 1000;
    char what_to_say[longest + 1], unless_there[PATH_MAX + 1];

    void stop(const int signal)
    {
      if (::access(unless_there, F_OK) != 0)
      {
        [[maybe_unused]] const ssize_t n_written =
            ::write(STDERR_FILENO, what_to_say, std::strlen(what_to_say));
      }
      std::signal(signal, SIG_DFL);
      std::raise(signal);
    }
  } // namespace

  void be_silent_after_failure(const std::string &file)
  {
    const std::string path = file.substr(0, PATH_MAX);
    std::memcpy(unless_there, path.c_str(), path.size() + 1);
  }

  void tell_when_interrupted(const std::string &words)
  {
    std::vector<int> heard; // a background program of a script ignores Ctrl-C
    for (const int signal : {SIGINT, SIGTERM})
      if (std::signal(signal, SIG_IGN) != SIG_IGN)
        heard.push_back(signal);
    const std::string line = "\n" + words.substr(0, longest - 2) + "\n";
    std::memcpy(what_to_say, line.c_str(), line.size() + 1);
    for (const int signal : heard)
      std::signal(signal, stop);
  }
} // namespace ringmotor
