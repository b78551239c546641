// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A file kept for a later run returns what was written, byte for byte and under the same key, or
// nothing.

#include "scratch.h"

#include <ringmotor/output/kept_file.h>
#include <ringmotor/parameters/fingerprint.h>

#include <boost/serialization/vector.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

using namespace ringmotor;
using namespace ringmotor::tests;

namespace
{
  // Keys of equal length, bytes that look like a file header, zeros.
  const std::string key = "preload 14\n", other_key = "preload 15\n",
                    bytes = std::string("12\nab\0\0\n\xff", 9);

  void write_bytes(const std::string &path, const std::string &content)
  {
    std::ofstream(path, std::ios::binary) << content;
  }
} // namespace

TEST(KeptFile, GivesBackWhatWasKept)
{
  const Scratch scratch;
  const std::string path = scratch.path("x");
  for (const std::string &content : {bytes, std::string()})
  {
    write_kept_file(path, key, content);
    const KeptContent kept = read_kept_file(path, key);
    ASSERT_TRUE(kept.bytes.has_value());
    EXPECT_EQ(*kept.bytes, content);
    EXPECT_EQ(kept.problem, "");
  }
  EXPECT_EQ(scratch.n_entries(), 1u);
}

TEST(KeptFile, GivesNothingWithoutAFileOrUnderAnotherKey)
{
  const Scratch scratch;
  EXPECT_FALSE(read_kept_file(scratch.path("x"), key).bytes);
  EXPECT_EQ(read_kept_file(scratch.path("x"), key).problem, "");
  write_kept_file(scratch.path("x"), key, bytes);
  for (const std::string &wrong : {other_key, std::string(), key.substr(0, 5), key + "1"})
  {
    const KeptContent kept = read_kept_file(scratch.path("x"), wrong);
    EXPECT_FALSE(kept.bytes) << wrong;
    EXPECT_EQ(kept.problem, "belongs to other parameters or another version");
  }
  EXPECT_EQ(read_kept_file(scratch.path(""), key).problem, "is damaged") << "a folder";
}

TEST(KeptFile, NoticesEachDamagedByteAndEachMissingPart)
{
  const Scratch scratch;
  const std::string path = scratch.path("x");
  write_kept_file(path, key, bytes);
  const std::string whole = content_of(path);
  for (std::size_t position = 0; position < whole.size(); ++position)
  {
    for (const int change : {0x01, 0x80, 0xff})
    {
      std::string damaged = whole;
      damaged[position] ^= change;
      write_bytes(path, damaged);
      EXPECT_FALSE(read_kept_file(path, key).bytes) << position;
      EXPECT_EQ(read_kept_file(path, key).problem, "is damaged") << position;
    }
    write_bytes(path, whole.substr(0, position));
    EXPECT_EQ(read_kept_file(path, key).problem, "is damaged") << position;
  }
  write_bytes(path, whole + "x");
  EXPECT_EQ(read_kept_file(path, key).problem, "is damaged");
  write_bytes(path, whole);
  EXPECT_TRUE(read_kept_file(path, key).bytes);
}

// The version 5 UUID of "www.example.com" in the name space of object identifiers, computed by
// Python: uuid.uuid5(uuid.NAMESPACE_OID, "www.example.com").
TEST(KeptFile, FingerprintsAreThoseOfTheStandard)
{
  EXPECT_EQ(fingerprint("www.example.com"), "a5e87d3b-479e-52da-b98a-db251a851854");
}

TEST(KeptFile, ObjectsComeBackToTheLastBit)
{
  const std::vector<double> numbers{1. / 3., -0., std::numeric_limits<double>::denorm_min(),
                                    std::numeric_limits<double>::infinity()};
  const auto again = from_bytes<std::vector<double>>(to_bytes(numbers));
  EXPECT_EQ(again, numbers);
  EXPECT_TRUE(std::signbit(again[1]));
}
