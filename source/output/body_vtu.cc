// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/output/body_vtu.h>
#include <ringmotor/output/files.h>

#include <deal.II/base/utilities.h>

#include <zlib.h>

#include <cstdint>
#include <cstring>
#include <ostream>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    std::string base64(const void *data, const std::size_t n_bytes)
    {
      const auto *bytes = static_cast<const unsigned char *>(data);
      return Utilities::encode_base64({bytes, bytes + n_bytes});
    }

    /** A data array in one block, compressed. */
    template <typename Number>
    void write_array(std::ostream &out, const std::string &type, const std::string &attributes,
                     const std::vector<Number> &values)
    {
      const uLong n_bytes = values.size() * sizeof(Number);
      uLongf packed_size  = compressBound(n_bytes);
      std::vector<unsigned char> packed(packed_size);
      const int result =
          compress2(packed.data(), &packed_size,
                    reinterpret_cast<const unsigned char *>(values.data()), n_bytes, Z_BEST_SPEED);
      AssertThrow(result == Z_OK, ExcMessage("zlib failed"));
      // number of blocks, their size, that of the last one, compressed size
      const std::array<std::uint32_t, 4> head{{1, static_cast<std::uint32_t>(n_bytes),
                                               static_cast<std::uint32_t>(n_bytes),
                                               static_cast<std::uint32_t>(packed_size)}};
      out << "<DataArray type=\"" << type << "\" " << attributes << " format=\"binary\">\n"
          << base64(head.data(), sizeof(head)) << base64(packed.data(), packed_size)
          << "\n</DataArray>\n";
    }

    void write_cells(std::ostream &out, const RingBody &body)
    {
      constexpr std::array<unsigned int, 8> vtk_order{{0, 1, 3, 2, 4, 5, 7, 6}};
      constexpr std::uint8_t hexahedron = 12;
      std::vector<std::int32_t> points, ends;
      for (const auto &cell : body.cells())
      {
        for (const unsigned int v : vtk_order)
          points.push_back(static_cast<std::int32_t>(cell[v]));
        ends.push_back(static_cast<std::int32_t>(points.size()));
      }
      out << "<Cells>\n";
      write_array(out, "Int32", "Name=\"connectivity\"", points);
      write_array(out, "Int32", "Name=\"offsets\"", ends);
      write_array(out, "UInt8", "Name=\"types\"",
                  std::vector<std::uint8_t>(body.cells().size(), hexahedron));
      out << "</Cells>\n";
    }
  } // namespace

  void write_body(const std::string &path, const RingBody &body,
                  const std::vector<PointField> &fields)
  {
    std::vector<float> positions;
    for (const Point<3> &point : body.points())
      for (unsigned int d = 0; d < 3; ++d)
        positions.push_back(static_cast<float>(point[d]));
    write_file(path,
               [&](std::ostream &out)
               {
                 out << "<?xml version=\"1.0\"?>\n"
                     << "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" "
                        "byte_order=\"LittleEndian\" compressor=\"vtkZLibDataCompressor\">\n"
                     << "<UnstructuredGrid>\n<Piece NumberOfPoints=\"" << body.points().size()
                     << "\" NumberOfCells=\"" << body.cells().size() << "\">\n<Points>\n";
                 write_array(out, "Float32", "NumberOfComponents=\"3\"", positions);
                 out << "</Points>\n";
                 write_cells(out, body);
                 out << "<PointData>\n";
                 for (const PointField &field : fields)
                   write_array(out, "Float32",
                               "Name=\"" + field.name + "\" NumberOfComponents=\"" +
                                   std::to_string(field.n_components) + "\" units=\"" + field.unit +
                                   "\"",
                               field.values);
                 out << "</PointData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
               });
  }
} // namespace ringmotor
