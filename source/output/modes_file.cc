// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/output/hdf5.h>
#include <ringmotor/output/kept_file.h>
#include <ringmotor/output/modes_file.h>
#include <ringmotor/output/stator_files.h>
#include <ringmotor/parameters/errors.h>

#include <deal.II/base/polynomial.h>

#include <cmath>
#include <filesystem>
#include <memory>
#include <sstream>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    using Complex = std::complex<double>;

    /** A motion sampled face by face, to be interpolated in the plane (r, theta). */
    class TraceInterpolation
    {
    public:
      TraceInterpolation(const Hdf5Reader &file, const std::string &group)
          : order(file.attribute<unsigned int>(group, "order"))
      {
        const std::size_t n_lattice = (order + 1) * (order + 1);
        const std::vector<std::size_t> any{Hdf5Reader::any_size, n_lattice, 3};
        const std::vector<double> points = file.read<double>(group + "/points", any, "m");
        const std::vector<double> real = file.read<double>(group + "/displacement_real", any, "m");
        const std::vector<double> imaginary =
            file.read<double>(group + "/displacement_imaginary", any, "m");
        content = to_bytes(order) + to_bytes(points) + to_bytes(real) + to_bytes(imaginary);
        for (std::size_t i = 0; i < real.size(); ++i)
          values.emplace_back(real[i], imaginary[i]);
        for (std::size_t face = 0; face < points.size() / (3 * n_lattice); ++face)
        {
          std::array<Point<2>, 4> corner;
          for (unsigned int v = 0; v < 4; ++v)
          {
            const std::size_t lattice = v / 2 * order * (order + 1) + v % 2 * order;
            const double *x           = points.data() + 3 * (face * n_lattice + lattice);
            corner[v]                 = Point<2>(std::hypot(x[0], x[1]), std::atan2(x[1], x[0]));
          }
          corners.push_back(corner);
        }
        std::vector<Point<1>> support;
        for (unsigned int i = 0; i <= order; ++i)
          support.emplace_back(i / static_cast<double>(order));
        basis = Polynomials::generate_complete_Lagrange_basis(support);
      }

      /** The r, theta, z components at a point of the surface. */
      std::array<Complex, 3> operator()(const Point<3> &x) const
      {
        const Point<2> place(std::hypot(x[0], x[1]), std::atan2(x[1], x[0]));
        std::size_t nearest = 0;
        Point<2> unit;
        double distance = std::numeric_limits<double>::infinity();
        for (std::size_t face = 0; face < corners.size(); ++face)
        {
          const Point<2> candidate = unit_point(corners[face], place);
          const double outside =
              std::max({-candidate[0], candidate[0] - 1., -candidate[1], candidate[1] - 1.});
          if (outside < distance)
          {
            distance = outside;
            nearest  = face;
            unit     = candidate;
          }
        }
        std::array<Complex, 3> motion{};
        const std::size_t n_lattice = (order + 1) * (order + 1);
        for (unsigned int j = 0; j <= order; ++j)
          for (unsigned int i = 0; i <= order; ++i)
          {
            const double weight = basis[i].value(unit[0]) * basis[j].value(unit[1]);
            for (unsigned int c = 0; c < 3; ++c)
              motion[c] += weight * values[3 * (nearest * n_lattice + j * (order + 1) + i) + c];
          }
        return motion;
      }

      /** All that the motion depends on. */
      std::string bytes() const { return content; }

    private:
      const unsigned int order;
      std::string content;
      std::vector<std::array<Point<2>, 4>> corners;
      std::vector<Complex> values;
      std::vector<Polynomials::Polynomial<double>> basis;
    };

    void check_same(const std::string &path, const std::string &entry, const double stored,
                    const double wanted)
    {
      if (std::abs(stored - wanted) <= 1e-9 * std::abs(wanted))
        return;
      std::ostringstream text;
      text << path << " belongs to another motor: it has " << entry << " = " << stored
           << ", the parameters have " << wanted
           << "; run the program stator with these parameters first";
      throw UserError(text.str());
    }
  } // namespace

  StatorWave read_stator_wave(const std::string &path, const Parameters &parameters)
  {
    if (!std::filesystem::exists(path))
      throw UserError(path + " does not exist: the contact needs the stator's wave; run the "
                             "program stator with the same parameter file first");
    const Hdf5Reader file(path, "ringmotor modes", modes_format_version);
    check_same(path, "Motor/Number of waves", file.attribute<unsigned int>("/", "n_waves"),
               parameters.motor.n_waves);
    check_same(path, "Motor/Number of teeth", file.attribute<unsigned int>("/", "n_teeth"),
               parameters.motor.n_teeth);
    for (const StatorEntry &entry : stator_fingerprint(parameters))
      check_same(path, entry.entry, file.attribute<double>(entry.group, entry.attribute),
                 entry.value);
    StatorWave wave;
    wave.n_waves = file.attribute<unsigned int>("/wave", "nodal_diameter");
    check_same(path, "Wave/Amplitude", file.attribute<double>("/wave", "amplitude_m"),
               parameters.wave.amplitude);
    wave.angular_frequency = file.attribute<double>("/wave", "angular_frequency_rad_per_s");
    if (parameters.wave.frequency)
      check_same(path, "Wave/Frequency", wave.angular_frequency / (2. * numbers::PI),
                 *parameters.wave.frequency);
    const auto relative_error =
        [&](const std::string &group, const std::string &value, const std::string &error)
    { return file.attribute<double>(group, error) / file.attribute<double>(group, value); };
    wave.relative_error =
        relative_error("/wave", "natural_frequency_Hz", "natural_frequency_error_Hz") +
        relative_error("/wave/shape", "A_t/A_n", "A_t/A_n error");
    const auto foot  = std::make_shared<TraceInterpolation>(file, "/wave/tooth_foot");
    const auto top   = std::make_shared<TraceInterpolation>(file, "/wave/tooth_top");
    wave.foot        = [foot](const Point<3> &x) { return (*foot)(x); };
    wave.top         = [top](const Point<3> &x) { return (*top)(x); };
    wave.fingerprint = fingerprint(foot->bytes() + top->bytes() + to_bytes(wave.n_waves) +
                                   to_bytes(wave.angular_frequency));
    return wave;
  }
} // namespace ringmotor
