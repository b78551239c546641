// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/output/files.h>
#include <ringmotor/output/vtu_file.h>

#include <deal.II/base/exceptions.h>

#include <zlib.h>

#include <algorithm>
#include <array>
#include <ostream>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    /** Bytes as letters. That of deal.II takes eighty times as long, and longer than compression.
     */
    std::string base64(const void *data, const std::size_t n_bytes)
    {
      constexpr char letters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
      const auto *bytes        = static_cast<const unsigned char *>(data);
      std::string text;
      text.reserve((n_bytes + 2) / 3 * 4);
      for (std::size_t i = 0; i < n_bytes; i += 3)
      {
        const std::size_t n_here = std::min<std::size_t>(3, n_bytes - i);
        std::uint32_t group      = 0;
        for (std::size_t j = 0; j < 3; ++j)
          group = 256 * group + (j < n_here ? bytes[i + j] : 0);
        for (std::size_t j = 0; j < 4; ++j)
          text += j <= n_here ? letters[(group >> (18 - 6 * j)) % 64] : '=';
      }
      return text;
    }

    /** A zlib stream of some bytes. */
    std::vector<unsigned char> compressed(const void *data, const std::size_t n_bytes,
                                          const int strategy)
    {
      constexpr int window_bits = 15, memory_level = 8; // the defaults
      z_stream stream{};
      int result =
          deflateInit2(&stream, Z_BEST_SPEED, Z_DEFLATED, window_bits, memory_level, strategy);
      AssertThrow(result == Z_OK, ExcMessage("zlib failed"));
      std::vector<unsigned char> packed(deflateBound(&stream, n_bytes));
      stream.next_in   = static_cast<Bytef *>(const_cast<void *>(data)); // which it only reads
      stream.avail_in  = n_bytes;
      stream.next_out  = packed.data();
      stream.avail_out = packed.size();
      result           = deflate(&stream, Z_FINISH);
      packed.resize(stream.total_out);
      deflateEnd(&stream);
      AssertThrow(result == Z_STREAM_END, ExcMessage("zlib failed"));
      return packed;
    }

    /** A data array in one block, compressed. */
    template <typename Number>
    std::string array(const std::string &type, const std::string &attributes,
                      const std::vector<Number> &values, const int strategy = Z_DEFAULT_STRATEGY)
    {
      const std::size_t n_bytes               = values.size() * sizeof(Number);
      const std::vector<unsigned char> packed = compressed(values.data(), n_bytes, strategy);
      // number of blocks, their size, that of the last one, compressed size
      const std::array<std::uint32_t, 4> head{{1, static_cast<std::uint32_t>(n_bytes),
                                               static_cast<std::uint32_t>(n_bytes),
                                               static_cast<std::uint32_t>(packed.size())}};
      return "<DataArray type=\"" + type + "\" " + attributes + " format=\"binary\">\n" +
             base64(head.data(), sizeof(head)) + base64(packed.data(), packed.size()) +
             "\n</DataArray>\n";
    }

    std::string array(const PointField &field, const int strategy)
    {
      return array("Float32",
                   "Name=\"" + field.name + "\" NumberOfComponents=\"" +
                       std::to_string(field.n_components) + "\"" +
                       (field.unit.empty() ? "" : " units=\"" + field.unit + "\""),
                   field.values, strategy);
    }
  } // namespace

  VtuGrid::VtuGrid(const std::vector<Point<3>> &points, const std::vector<std::int32_t> &cells,
                   const unsigned int points_per_cell, const VtuCell type)
      : n_points(points.size()), n_cells(cells.size() / points_per_cell)
  {
    std::vector<float> positions;
    for (const Point<3> &point : points)
      for (unsigned int d = 0; d < 3; ++d)
        positions.push_back(static_cast<float>(point[d]));
    std::vector<std::int32_t> ends;
    for (std::size_t cell = 1; cell <= n_cells; ++cell)
      ends.push_back(static_cast<std::int32_t>(cell * points_per_cell));
    points_and_cells = "<Points>\n" + array("Float32", "NumberOfComponents=\"3\"", positions) +
                       "</Points>\n<Cells>\n" + array("Int32", "Name=\"connectivity\"", cells) +
                       array("Int32", "Name=\"offsets\"", ends) +
                       array("UInt8", "Name=\"types\"",
                             std::vector<std::uint8_t>(n_cells, static_cast<std::uint8_t>(type))) +
                       "</Cells>\n";
  }

  void VtuGrid::add(const PointField &field)
  {
    common_fields += array(field, Z_DEFAULT_STRATEGY);
  }

  void VtuGrid::write(const std::string &path, const std::vector<PointField> &fields) const
  {
    write_file(path,
               [&](std::ostream &out)
               {
                 // Version 2.2 means the numbers of a Lagrange cell's nodes since VTK 9.1.
                 out << "<?xml version=\"1.0\"?>\n"
                     << "<VTKFile type=\"UnstructuredGrid\" version=\"2.2\" "
                        "byte_order=\"LittleEndian\" compressor=\"vtkZLibDataCompressor\">\n"
                     << "<UnstructuredGrid>\n<Piece NumberOfPoints=\"" << n_points
                     << "\" NumberOfCells=\"" << n_cells << "\">\n"
                     << points_and_cells << "<PointData>\n";
                 // Their numbers hardly repeat themselves but in runs, of zeros: looking for more
                 // takes eight times as long.
                 for (const PointField &field : fields)
                   out << array(field, Z_RLE);
                 out << common_fields
                     << "</PointData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
               });
  }
} // namespace ringmotor
