// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>
#include <iosfwd>
#include <string>
#include <string_view>

// Everything in this folder accesses files or the terminal: call it on MPI rank 0 only.

namespace ringmotor
{
  /**
   * Makes sure that results can be written to a folder before anything is computed: creates it with
   * its missing parents and writes a small test file there.
   *
   * @throw UserError (one line, entry `Output/Directory`) with the system's reason, e.g. the path
   * is a file, the file system is read-only or full.
   */
  void prepare_directory(const std::string &path);

  /**
   * Writes a file all or nothing: @p content goes to `path + ".part"`, which gets the name @p path
   * only when every byte has reached the disk. Replaces an older file of that name. Binary safe.
   *
   * A process that runs under a file size limit must ignore SIGXFSZ, else the system ends it before
   * the failure can be reported.
   *
   * @throw UserError (one line, entry `Output/Directory`) with the path, the system's reason and
   * what to do; then neither the part nor a new file under the final name remains.
   */
  void write_file(const std::string &path, std::string_view content);

  /**
   * The same for a content that is streamed. @p write runs to its end, in memory, before the file
   * is opened: an exception from it leaves no trace on the disk.
   */
  void write_file(const std::string &path, const std::function<void(std::ostream &)> &write);
} // namespace ringmotor
