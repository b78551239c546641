// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/output/files.h>
#include <ringmotor/parameters/errors.h>
#include <ringmotor/programs/case_lock.h>

#include <cerrno>
#include <fcntl.h>
#include <filesystem>
#include <iostream>
#include <sys/file.h>
#include <system_error>
#include <unistd.h>

namespace ringmotor
{
  namespace
  {
    bool exists(const std::string &path)
    {
      std::error_code no_throw;
      return std::filesystem::exists(path, no_throw);
    }
  } // namespace

  CaseLock::CaseLock(const std::string &folder) : folder(folder), is_new(!exists(folder))
  {
    if (is_new)
      prepare_directory(folder);
    descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor >= 0 && ::flock(descriptor, LOCK_EX | LOCK_NB) == 0)
      return;
    if (descriptor >= 0 && errno == EWOULDBLOCK)
    {
      ::close(descriptor);
      throw UserError("Output/Directory = " + folder +
                      ": another program is running in this folder; wait until it has ended, or "
                      "choose another folder (--output DIR)");
    }
    // Some network file systems lock no folders; any other problem with the folder is reported when
    // results are written.
    std::cerr << "warning: the folder " << folder << " cannot be locked ("
              << std::generic_category().message(errno)
              << "): let no other program work in it at the same time" << std::endl;
  }

  CaseLock::~CaseLock()
  {
    std::error_code no_throw;
    if (is_new && std::filesystem::is_empty(folder, no_throw) && !no_throw)
      std::filesystem::remove(folder, no_throw);
    if (descriptor >= 0)
      ::close(descriptor);
  }
} // namespace ringmotor
