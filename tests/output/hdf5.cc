// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Data written to an HDF5 file is read back bit for bit, and a file other than the expected one is
// refused in one line that names the file, the dataset, what was found and what was expected.

#include "scratch.h"

#include <ringmotor/output/files.h>
#include <ringmotor/output/hdf5.h>
#include <ringmotor/parameters/errors.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <gtest/gtest.h>
#include <hdf5.h>
#include <limits>

using namespace ringmotor;
using namespace ringmotor::tests;

namespace
{
  using Sizes = std::vector<std::size_t>;

  const std::vector<std::string> families = {"axial", "", "\xc2\xb5m"};
  const std::vector<double> shape         = {1. / 3., -0., 2e-308, 1e300, 0.1, -7.};

  void write_example(const std::string &path)
  {
    Hdf5Writer writer("example", 3);
    writer.write("mode/shape", shape, {2, 3}, "m", "A shape: node x component.");
    writer.write("mode/wave_numbers", std::vector<int>{-7, 0, 45}, {3}, "1", "Signed.");
    writer.write("nodes", std::vector<unsigned int>{4294967295u}, {1}, "1", "Numbers of nodes.");
    writer.write("families", families, {3}, "", "Names.");
    writer.write("empty", std::vector<double>{}, {0, 3}, "m", "Nothing.");
    writer.write("scalar", std::vector<double>{0.5}, {}, "N", "No dimension.");
    writer.set_attribute("/", "version", std::string("0.1.0"));
    writer.set_attribute("mode", "frequency", 30004.1);
    writer.set_attribute("materials/invar", "id", 2);
    writer.save(path);
  }

  void expect_problem(const std::string &path, const std::string &problem,
                      const std::function<void()> &action)
  {
    EXPECT_EQ(message_of<UserError>(action),
              "'" + path + "'" + problem + "; write the file again with the program it comes from");
  }
} // namespace

TEST(Hdf5, GivesBackWhatWasWritten)
{
  const Scratch scratch;
  write_example(scratch.path("x.h5"));
  EXPECT_EQ(scratch.n_entries(), 1u);
  const Hdf5Reader reader(scratch.path("x.h5"), "example", 3);

  EXPECT_EQ(reader.dims("mode/shape"), (Sizes{2, 3}));
  EXPECT_EQ(reader.read<double>("mode/shape", {2, 3}, "m"), shape);
  EXPECT_EQ(reader.read<double>("mode/shape", {Hdf5Reader::any_size, 3}, "m"), shape);
  EXPECT_EQ(reader.read<int>("mode/wave_numbers", {3}, "1"), (std::vector<int>{-7, 0, 45}));
  EXPECT_EQ(reader.read<unsigned int>("nodes", {1}, "1"), std::vector<unsigned int>{4294967295u});
  EXPECT_EQ(reader.read<std::string>("families", {3}, ""), families);
  EXPECT_TRUE(reader.read<double>("empty", {Hdf5Reader::any_size, 3}, "m").empty());

  EXPECT_EQ(reader.read<double>("scalar", {}, "N"), std::vector<double>{0.5});

  EXPECT_EQ(reader.attribute<std::string>("/", "version"), "0.1.0");
  EXPECT_EQ(reader.attribute<double>("mode", "frequency"), 30004.1);
  EXPECT_EQ(reader.attribute<int>("materials/invar", "id"), 2);
  EXPECT_EQ(reader.attribute<std::string>("mode/shape", "description"),
            "A shape: node x component.");
}

TEST(Hdf5, RefusesADatasetThatIsNotTheExpectedOne)
{
  const Scratch scratch;
  const std::string path = scratch.path("x.h5");
  write_example(path);
  const Hdf5Reader reader(path, "example", 3);

  testing::internal::CaptureStderr();
  expect_problem(path, ", dataset 'mode/speed': found nothing, expected values",
                 [&]() { reader.read<double>("mode/speed", {1}, "m"); });
  expect_problem(path, ", dataset 'no/such/group': found nothing, expected values",
                 [&]() { reader.dims("no/such/group"); });
  expect_problem(path, ", dataset 'mode': found nothing, expected values",
                 [&]() { reader.dims("mode"); });
  expect_problem(path,
                 ", dataset 'mode/shape': found the size (2 x 3), expected the size (any x 2)",
                 [&]() {
                   reader.read<double>("mode/shape", {Hdf5Reader::any_size, 2}, "m");
                 });
  expect_problem(path, ", dataset 'mode/shape': found the size (2 x 3), expected the size (2)",
                 [&]() { reader.read<double>("mode/shape", {2}, "m"); });
  expect_problem(path, ", dataset 'mode/shape': found the unit 'm', expected 'um'",
                 [&]() {
                   reader.read<double>("mode/shape", {2, 3}, "um");
                 });
  expect_problem(path, ", dataset 'families': found texts, expected numbers",
                 [&]() { reader.read<double>("families", {3}, ""); });
  expect_problem(path, ", dataset 'mode/shape': found floating point numbers, expected integers",
                 [&]() {
                   reader.read<int>("mode/shape", {2, 3}, "m");
                 });
  expect_problem(path, ", attribute 'mass' of 'mode': found nothing, expected a value",
                 [&]() { reader.attribute<double>("mode", "mass"); });
  expect_problem(path, ", attribute 'mass' of 'no/mode': found nothing, expected a value",
                 [&]() { reader.attribute<double>("no/mode", "mass"); });
  expect_problem(path, ", attribute 'version' of '/': found texts, expected one value from numbers",
                 [&]() { reader.attribute<double>("/", "version"); });
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << "HDF5 itself must stay silent";
}

TEST(Hdf5, RefusesNumbersThatAreNotFiniteOrOutsideTheirRange)
{
  const Scratch scratch;
  const std::string path = scratch.path("x.h5");
  const double infinity  = std::numeric_limits<double>::infinity();
  Hdf5Writer writer("example", 1);
  writer.write("shape", std::vector<double>{1., std::nan("")}, {2}, "m", "Not a number.");
  writer.set_attribute("shape", "scale", -infinity);
  writer.set_attribute("shape", "order", 3u);
  writer.save(path);
  const Hdf5Reader reader(path, "example", 1);
  expect_problem(path, ", dataset 'shape': found values that are not finite, expected numbers",
                 [&]() { reader.read<double>("shape", {2}, "m"); });
  expect_problem(path,
                 ", attribute 'scale' of 'shape': found a value that is not finite, expected a "
                 "number",
                 [&]() { reader.attribute<double>("shape", "scale"); });
  EXPECT_EQ(reader.attribute_between<unsigned int>("shape", "order", 3, 3), 3u);
  for (const unsigned int least : {1u, 4u})
    expect_problem(path,
                   ", attribute 'order' of 'shape': found 3, expected a number between " +
                       std::to_string(least) + " and " + std::to_string(least + 1),
                   [&]()
                   { reader.attribute_between<unsigned int>("shape", "order", least, least + 1); });
}

TEST(Hdf5, RefusesTextsOfVariableLength)
{
  const Scratch scratch;
  const std::string path = scratch.path("x.h5");
  write_example(path);
  {
    const Hdf5Handle file(H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT));
    const Hdf5Handle space(H5Screate(H5S_SCALAR)), type(H5Tcopy(H5T_C_S1));
    H5Tset_size(type, H5T_VARIABLE);
    const Hdf5Handle attribute(H5Acreate_by_name(file, "mode", "name", type, space, H5P_DEFAULT,
                                                 H5P_DEFAULT, H5P_DEFAULT));
    const char *const text = "of any length";
    H5Awrite(attribute, type, &text);
  }
  expect_problem(path,
                 ", attribute 'name' of 'mode': found texts of variable length, expected one value "
                 "from texts",
                 [&]() { Hdf5Reader(path, "example", 3).attribute<std::string>("mode", "name"); });
}

TEST(Hdf5, RefusesAFileOfAnotherKind)
{
  const Scratch scratch;
  const std::string path = scratch.path("x.h5");
  write_example(path);
  expect_problem(path, ": found version 3 of its format, expected version 4",
                 [&]() { Hdf5Reader(path, "example", 4); });
  expect_problem(path, ": found the format 'example', expected 'other'",
                 [&]() { Hdf5Reader(path, "other", 3); });
  expect_problem(scratch.path("y.h5"), ": found nothing, expected a readable HDF5 file",
                 [&]() { Hdf5Reader(scratch.path("y.h5"), "example", 3); });
  expect_problem(scratch.path(""),
                 ": found a damaged file, or another format, expected a readable HDF5 "
                 "file",
                 [&]() { Hdf5Reader(scratch.path(""), "example", 3); });
}

TEST(Hdf5, RefusesAFileThatWasCutOff)
{
  const Scratch scratch;
  const std::string path = scratch.path("x.h5");
  write_example(path);
  const std::string whole = content_of(path);

  H5Eset_auto2(H5E_DEFAULT, reinterpret_cast<H5E_auto2_t>(H5Eprint2), stderr); // as at the start
  testing::internal::CaptureStderr();
  for (std::size_t size = 0; size < whole.size(); size += 1 + whole.size() / 50)
  {
    write_file(path, whole.substr(0, size));
    expect_problem(path,
                   ": found a damaged file, or another format, expected a readable HDF5 "
                   "file",
                   [&]() { Hdf5Reader(path, "example", 3); });
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << "HDF5 itself must stay silent";
}

// With one byte damaged anywhere, the file is refused or (if the byte was irrelevant) still gives
// the right values: never wrong ones, never a crash of HDF5.
TEST(Hdf5, NeverGivesDamagedValues)
{
  const Scratch scratch;
  const std::string path = scratch.path("x.h5");
  write_example(path);
  const std::string whole = content_of(path);

  unsigned int n_refused = 0;
  for (std::size_t position = 0; position < whole.size(); ++position)
  {
    std::string damaged = whole;
    damaged[position] ^= 0x55;
    std::ofstream(path, std::ios::binary) << damaged;
    try
    {
      const Hdf5Reader reader(path, "example", 3);
      EXPECT_EQ(reader.read<double>("mode/shape", {2, 3}, "m"), shape) << position;
      EXPECT_EQ(reader.read<int>("mode/wave_numbers", {3}, "1"), (std::vector<int>{-7, 0, 45}));
      EXPECT_EQ(reader.read<std::string>("families", {3}, ""), families) << position;
      EXPECT_EQ(reader.attribute<double>("mode", "frequency"), 30004.1) << position;
    }
    catch (const UserError &)
    {
      ++n_refused;
    }
  }
  EXPECT_GT(n_refused, whole.size() / 4);
}

TEST(Hdf5, RefusesToWriteANameTwice)
{
  Hdf5Writer writer("example", 1);
  const auto write = [&writer]()
  { writer.write("a", std::vector<double>{1.}, {1}, "m", "Something."); };
  write();
  EXPECT_EQ(message_of<ComputationError>(write), "HDF5 failed to write the dataset 'a'");
}

TEST(Hdf5, WritersDoNotMixUp)
{
  const Scratch scratch;
  Hdf5Writer first("first", 1), second("second", 1);
  second.write("values", std::vector<double>{2.}, {1}, "m", "Of the second.");
  first.write("values", std::vector<double>{1.}, {1}, "m", "Of the first.");
  second.save(scratch.path("second.h5"));
  first.save(scratch.path("first.h5"));
  EXPECT_EQ(Hdf5Reader(scratch.path("first.h5"), "first", 1).read<double>("values", {1}, "m"),
            std::vector<double>{1.});
  EXPECT_EQ(Hdf5Reader(scratch.path("second.h5"), "second", 1).read<double>("values", {1}, "m"),
            std::vector<double>{2.});
}

TEST(Hdf5, LeavesNothingOnAFullDisk)
{
  const Scratch scratch;
  std::filesystem::create_symlink("/dev/full", scratch.path("x.h5.part"));
  const std::string message = message_of<UserError>([&]() { write_example(scratch.path("x.h5")); });
  EXPECT_NE(message.find("No space left on device"), std::string::npos) << message;
  EXPECT_EQ(scratch.n_entries(), 0u);
}
