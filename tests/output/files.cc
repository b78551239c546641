// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Files are written completely or not at all, and disk errors are reported in one line. The
// expected reasons are the system's texts of the errors that the kernel documents: /dev/full always
// answers "no space left", a size limit of the process (setrlimit) "file too large".

#include "scratch.h"

#include <ringmotor/output/files.h>
#include <ringmotor/parameters/errors.h>

#include <algorithm>
#include <csignal>
#include <gtest/gtest.h>
#include <ostream>
#include <sys/resource.h>

using namespace ringmotor;
using namespace ringmotor::tests;

namespace
{
  void expect_refusal(const std::string &message, const std::string &path,
                      const std::string &reason)
  {
    EXPECT_EQ(std::count(message.begin(), message.end(), '\n'), 0) << message;
    for (const std::string &part : {std::string("Output/Directory"), "'" + path + "'", reason})
      EXPECT_NE(message.find(part), std::string::npos) << part << " is missing in: " << message;
  }

  std::string refusal_to_write(const std::string &path, const std::string_view content = "new")
  {
    return message_of<UserError>([&]() { write_file(path, content); });
  }

  /** Limits the size of files that this process can write, as a full disk would. */
  class FileSizeLimit
  {
  public:
    explicit FileSizeLimit(const rlim_t n_bytes) : handler(std::signal(SIGXFSZ, SIG_IGN))
    {
      getrlimit(RLIMIT_FSIZE, &before);
      const rlimit limit = {n_bytes, before.rlim_max};
      setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FileSizeLimit()
    {
      setrlimit(RLIMIT_FSIZE, &before);
      std::signal(SIGXFSZ, handler);
    }

  private:
    rlimit before;
    void (*const handler)(int);
  };
} // namespace

TEST(OutputFiles, KeepEveryByteAndReplaceAnOlderFile)
{
  const Scratch scratch;
  const std::string path = scratch.path("result.bin");
  const std::string bytes("\0\r\n\xff\x1a text \0", 13);

  write_file(path, "an older and longer content");
  write_file(path, bytes);
  EXPECT_EQ(content_of(path), bytes);
  write_file(path, [&bytes](std::ostream &out) { out << bytes << bytes; });
  EXPECT_EQ(content_of(path), bytes + bytes);
  EXPECT_EQ(scratch.n_entries(), 1u);
}

TEST(OutputFiles, KeepTheOlderFileWhenTheDiskIsFull)
{
  const Scratch scratch;
  const std::string path = scratch.path("result.csv");
  write_file(path, "old");
  std::filesystem::create_symlink("/dev/full", path + ".part");

  expect_refusal(refusal_to_write(path), path, "No space left on device");
  EXPECT_EQ(content_of(path), "old");
  EXPECT_EQ(scratch.n_entries(), 1u);
}

TEST(OutputFiles, LeaveNothingWhenAFileGrowsTooLarge)
{
  const Scratch scratch;
  const std::string path = scratch.path("result.csv");
  std::string message;
  {
    const FileSizeLimit limit(100000);
    message = refusal_to_write(path, std::string(100001, 'x'));
  }
  expect_refusal(message, path, "File too large");
  EXPECT_EQ(scratch.n_entries(), 0u);
}

TEST(OutputFiles, LeaveNothingWhenTheWriterFails)
{
  const Scratch scratch;
  const auto half_way = [](std::ostream &out)
  {
    out << "half";
    throw ComputationError("no more");
  };
  EXPECT_EQ(message_of<ComputationError>([&]() { write_file(scratch.path("x"), half_way); }),
            "no more");
  EXPECT_EQ(scratch.n_entries(), 0u);
}

TEST(OutputFiles, RefuseAMissingFolderAndAFolderInTheWay)
{
  const Scratch scratch;
  const std::string nowhere = scratch.path("missing/result.csv");
  expect_refusal(refusal_to_write(nowhere), nowhere, "No such file or directory");

  const std::string taken = scratch.path("taken");
  std::filesystem::create_directory(taken);
  expect_refusal(refusal_to_write(taken), taken, "Is a directory");
  EXPECT_EQ(scratch.n_entries(), 1u);
}

TEST(OutputFolder, IsMadeWithItsParentsAndLeftEmpty)
{
  const Scratch scratch;
  for (const char *name : {"case/stator", "case/stator", "other/"})
  {
    prepare_directory(scratch.path(name));
    EXPECT_TRUE(std::filesystem::is_empty(scratch.path(name)));
  }
}

TEST(OutputFolder, IsRefusedWhereItCannotBeMadeOrWritten)
{
  const Scratch scratch;
  const auto refusal = [](const std::string &path)
  { return message_of<UserError>([&]() { prepare_directory(path); }); };

  const std::string file = scratch.path("file");
  write_file(file, "in the way");
  expect_refusal(refusal(file), file, "Not a directory");
  expect_refusal(refusal(file + "/below"), file + "/below", "Not a directory");

  // The kernel's own folders accept no files from any user.
  expect_refusal(refusal("/proc/ringmotor"), "/proc/ringmotor", "No such file or directory");
  expect_refusal(refusal("/proc"), "/proc", "No such file or directory");
}

TEST(OutputFolder, IsRefusedOnAFullDisk)
{
  const Scratch scratch;
  const std::string folder = scratch.path("results");
  prepare_directory(folder);
  std::filesystem::create_symlink("/dev/full", folder + "/.ringmotor_write_test");

  expect_refusal(message_of<UserError>([&]() { prepare_directory(folder); }), folder,
                 "No space left on device");
  EXPECT_TRUE(std::filesystem::is_empty(folder));
}
