// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/output/files.h>
#include <ringmotor/parameters/errors.h>

#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <filesystem>
#include <sstream>
#include <system_error>
#include <unistd.h>

namespace ringmotor
{
  namespace
  {
    [[noreturn]] void refuse(const std::string &action, const std::string &path, const int reason)
    {
      const bool is_full = reason == ENOSPC || reason == EDQUOT || reason == EFBIG;
      throw UserError("Output/Directory: cannot " + action + " '" + path +
                      "': " + std::generic_category().message(reason) + "; " +
                      (is_full ? "free some space or choose another folder"
                               : "choose a folder that can be written") +
                      " (the entry Output/Directory or --output DIR)");
    }

    enum class Kept
    {
      yes,
      no ///< the file has no name from the beginning on: nothing is left, whatever ends the program
    };

    /** Writes, flushes to the disk and closes. Returns 0 or the errno of the first failed step. */
    int write_to_disk(const std::string &path, const std::string_view content, const Kept kept)
    {
      const int descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
      if (descriptor < 0)
        return errno;
      if (kept == Kept::no)
        std::remove(path.c_str());

      int reason = 0;
      for (std::size_t done = 0; done < content.size() && reason == 0;)
      {
        const ssize_t n_written = ::write(descriptor, content.data() + done, content.size() - done);
        if (n_written >= 0)
          done += n_written;
        else if (errno != EINTR)
          reason = errno;
      }
      // Network file systems and quotas may report a full disk only here.
      if (reason == 0 && ::fsync(descriptor) != 0)
        reason = errno;
      if (::close(descriptor) != 0 && reason == 0)
        reason = errno;
      return reason;
    }
  } // namespace

  void prepare_directory(const std::string &path)
  {
    std::error_code error;
    std::filesystem::create_directories(path, error);
    if (error)
      refuse("create the folder", path, error.value());

    // Permission bits say little (read-only file systems, quotas, root): try it.
    const std::string trial_file = path + "/.ringmotor_write_test";
    const int reason = write_to_disk(trial_file, "a test file, may be deleted\n", Kept::no);
    if (reason != 0)
      refuse("write to the folder", path, reason);
  }

  void write_file(const std::string &path, const std::string_view content)
  {
    const std::string part = path + ".part";

    int reason = write_to_disk(part, content, Kept::yes);
    if (reason == 0 && std::rename(part.c_str(), path.c_str()) != 0)
      reason = errno;
    if (reason != 0)
    {
      std::remove(part.c_str());
      refuse("write", path, reason);
    }
  }

  void write_file(const std::string &path, const std::function<void(std::ostream &)> &write)
  {
    std::ostringstream content;
    write(content);
    write_file(path, content.str());
  }
} // namespace ringmotor
