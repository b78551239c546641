// SPDX-License-Identifier: LGPL-2.1-or-later

// The interpretation of valid parameter files. The expected numbers are the reference motor's data
// sheet (the paper's values where it states them, see prm/canon_ring.prm), written out once more
// here; texts written by the test itself; and, for round trips, the value that went in.

#include "sample.h"

#include <ringmotor/motor/effect.h>
#include <ringmotor/parameters/entries.h>
#include <ringmotor/parameters/prm_file.h>

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <numeric>

using namespace ringmotor;
using ringmotor::sample::complete_text;
using ringmotor::sample::printed;
using ringmotor::sample::with;

namespace
{
  const std::string source_folder = RINGMOTOR_SOURCE_DIR;

  /** Dimensions in mm: base inner and outer, tip inner and outer radius, thickness of the base,
   * height of the teeth; radii of the ring, its faces, flange thickness, radii of the lip. */
  using Dimensions = std::vector<double>;
  const Dimensions of_canon_ring{29.6, 35.6, 30.0, 34.2, 4.153, 1.7, 34.95,
                                 41.0, -1.5, 6.5,  0.27, 34.05, 34.2},
      of_soft_spring{30.0, 36.0, 30.0, 34.2, 4.37, 2.0, 36.5, 41.0, -3.0, 3.6, 0.6, 33.2, 34.2};

  void expect_dimensions(const StatorGeometry &stator, const RotorGeometry &rotor,
                         const Dimensions &expected)
  {
    const Dimensions found{
        stator.base_inner_radius, stator.base_outer_radius, stator.tip_inner_radius,
        stator.tip_outer_radius,  stator.base_thickness,    stator.tooth_height,
        rotor.ring_inner_radius,  rotor.ring_outer_radius,  rotor.ring_lower_face,
        rotor.ring_upper_face,    rotor.flange_thickness,   rotor.lip_inner_radius,
        rotor.lip_outer_radius};
    for (std::size_t i = 0; i < found.size(); ++i)
      EXPECT_DOUBLE_EQ(found[i], std::stod(std::to_string(expected[i]) + "e-3")) << i;
    EXPECT_DOUBLE_EQ(stator.slot_width, 0.0006);
    EXPECT_DOUBLE_EQ(stator.piezoceramic_thickness, 0.0005);
    EXPECT_EQ(stator.piezoceramic_element, ElementKind::solid);
    EXPECT_EQ(stator.mesh_file, "");
    EXPECT_EQ(rotor.flange_lower_face, 0.);
    EXPECT_EQ(rotor.flange_element, ElementKind::shell);
    EXPECT_DOUBLE_EQ(rotor.radial_bar_stiffness, 1e9);
  }

  /** What both motors have in common. */
  void expect_data_of_the_paper(const Parameters &parameters)
  {
    EXPECT_EQ(parameters.motor.n_waves, 7u);
    EXPECT_EQ(parameters.motor.n_teeth, 90u);

    const auto expect_material =
        [](const Material &material, const double modulus, const double ratio, const double density)
    {
      EXPECT_DOUBLE_EQ(material.young_modulus, modulus);
      EXPECT_DOUBLE_EQ(material.poisson_ratio, ratio);
      EXPECT_DOUBLE_EQ(material.density, density);
    };
    expect_material(parameters.materials.stator_metal, 141e9, 0.29, 8100.);
    expect_material(parameters.materials.piezoceramic, 81e9, 0.31, 7600.);
    expect_material(parameters.materials.rotor_metal, 68.9e9, 0.33, 2700.);

    EXPECT_DOUBLE_EQ(parameters.wave.amplitude, 2e-6);
    EXPECT_FALSE(parameters.wave.frequency.has_value());
    EXPECT_DOUBLE_EQ(parameters.loading.preload, 14.);
    EXPECT_EQ(parameters.loading.control, Control::torque);
    EXPECT_EQ(parameters.friction.law, FrictionLaw("static-dynamic"));
    EXPECT_DOUBLE_EQ(parameters.friction.static_coefficient, 0.48);
    EXPECT_DOUBLE_EQ(parameters.friction.dynamic_coefficient, 0.40);
    EXPECT_EQ(parameters.initial_deformation.amplitude, 0.);
    EXPECT_EQ(parameters.initial_deformation.n_waves, 2u);
    EXPECT_DOUBLE_EQ(parameters.time.time_step, 5e-7);
    EXPECT_FALSE(parameters.time.n_steps.has_value());
    EXPECT_FALSE(parameters.time.average_from_step.has_value());
    EXPECT_FALSE(parameters.time.average_to_step.has_value());
    EXPECT_EQ(nodal_diameters_of(parameters), std::vector<unsigned int>{7});
    EXPECT_EQ(parameters.modes.n_modes, 2u);
  }

  /** All but those that are off unless they are asked for. */
  void expect_effects_on_auto(const Parameters &parameters)
  {
    for (const auto &effect : all_effects())
    {
      const bool is_off = effect->name == "Target plates" || effect->name == "Stator compliance" ||
                          effect->name == "Piezoelectric coupling";
      EXPECT_EQ(effect->choice(parameters), is_off ? EffectChoice::off : EffectChoice::automatic)
          << effect->name;
    }
  }
} // namespace

TEST(Reading, DefaultsAreTheMotorWithASoftSpring)
{
  const Parameters defaults, file = read_parameters(source_folder + "/prm/soft_spring.prm");
  for (const Parameters &parameters : {defaults, file})
  {
    expect_dimensions(parameters.stator, parameters.rotor, of_soft_spring);
    expect_data_of_the_paper(parameters);
    EXPECT_NO_THROW(check_for_stator(parameters));
  }
}

TEST(Reading, CanonRingFileIsTheReferenceMotor)
{
  const Parameters parameters = read_parameters(source_folder + "/prm/canon_ring.prm");
  expect_dimensions(parameters.stator, parameters.rotor, of_canon_ring);
  expect_data_of_the_paper(parameters);
  expect_effects_on_auto(parameters);
  EXPECT_EQ(parameters.accuracy.target, 1e-4);
  EXPECT_EQ(parameters.accuracy.mode, AccuracyMode::adaptive);
  EXPECT_EQ(parameters.output.directory, "output/canon_ring");
  EXPECT_TRUE(parameters.variant.base.empty());
  EXPECT_NO_THROW(check_for_stator(parameters));
}

TEST(Reading, QuickFileIsTheReferenceMotorAtLessAccuracy)
{
  const Parameters reference = read_parameters(source_folder + "/prm/canon_ring.prm");
  Parameters quick           = read_parameters(source_folder + "/prm/quick.prm");
  EXPECT_GT(quick.accuracy.contact_target, reference.accuracy.contact_target);
  EXPECT_LT(quick.loading.n_curve_points, reference.loading.n_curve_points);
  // Accuracy, points and names of files apart, the two are the same motor: effects, too.
  quick.motor.name             = reference.motor.name;
  quick.accuracy               = reference.accuracy;
  quick.loading.n_curve_points = reference.loading.n_curve_points;
  quick.output                 = reference.output;
  EXPECT_EQ(printed(quick), printed(reference));
}

TEST(Reading, AFileWithoutEffectsHasAllOfThemOnAuto)
{
  const std::string all = source_folder + "/prm/canon_ring.prm";
  std::ifstream stream(all);
  std::string text((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
  const std::size_t begin = text.find("subsection Effects\n"), end = text.find("end\n", begin);
  ASSERT_NE(begin, std::string::npos);
  text.erase(begin, end + 4 - begin);
  EXPECT_EQ(text_of(read_parameters_from_text(text, all)), text_of(read_parameters(all)));
}

TEST(Reading, ATemplateHasTheDefaultsAndNoValueOfARequiredEntry)
{
  std::ostringstream stream;
  print_template(stream);
  const std::string text = stream.str();
  for (const std::string entry : {"Number of waves", "Preload", "Static coefficient", "Density"})
  {
    const std::size_t line = text.find("set " + entry + " ");
    ASSERT_NE(line, std::string::npos) << entry;
    const std::string rest = text.substr(line, text.find('\n', line) - line);
    EXPECT_EQ(rest.substr(rest.find('=')), "= # required") << rest;
  }
  EXPECT_NE(text.find("set Contact target       = 0.1\n"), std::string::npos) << text;
}

TEST(Reading, PrintedTextIsReadBackAndPrintedTheSame)
{
  const Parameters first  = read_parameters_from_text(complete_text(), "some/where/ring.prm");
  const Parameters second = read_parameters_from_text(printed(first), "other.prm");
  EXPECT_EQ(printed(first), printed(second));

  // The one value that depends on the file: its name is the name of the case.
  EXPECT_EQ(first.output.directory, "output/ring");
  Parameters default_case       = first;
  default_case.output.directory = Parameters().output.directory;
  EXPECT_EQ(printed(default_case), complete_text());
}

TEST(Reading, NumbersAreShortAndExactInPrint)
{
  Parameters parameters;
  parameters.wave.amplitude           = 2e-6 * (1. + std::numeric_limits<double>::epsilon());
  parameters.stator.slot_width        = 1e-3 * (0.1 + 0.2);
  parameters.materials.piezoceramic   = {1. / 3. * 1e11, 0.1 / 3., 7600., 0.};
  parameters.friction.decay_velocity  = std::sqrt(2.);
  parameters.loading.values           = {0., 0.05, 1. / 7.};
  parameters.accuracy.quantities      = {{"torque", 1. / 30.}, {"teeth_in_contact_per_wave", {}}};
  parameters.output.history_points    = {{0., 0.0342}, {100. / 7., 1. / 29.}};
  parameters.modes.nodal_diameters    = {0, 2, 3, 4, 9, 44, 45};
  parameters.effects["Rotor inertia"] = EffectChoice::automatic;
  parameters.output.vtu               = false;
  const std::string text              = printed(parameters);
  const Parameters back               = read_parameters_from_text(text, "exact.prm");

  EXPECT_EQ(back.wave.amplitude, parameters.wave.amplitude);
  EXPECT_EQ(back.stator.slot_width, parameters.stator.slot_width);
  EXPECT_EQ(back.materials.piezoceramic.young_modulus, 1. / 3. * 1e11);
  EXPECT_EQ(back.materials.piezoceramic.poisson_ratio, 0.1 / 3.);
  EXPECT_EQ(back.friction.decay_velocity, parameters.friction.decay_velocity);
  EXPECT_EQ(back.loading.values, parameters.loading.values);
  ASSERT_EQ(back.accuracy.quantities.size(), 2u);
  EXPECT_EQ(back.accuracy.quantities[0].quantity, "torque");
  EXPECT_EQ(back.accuracy.quantities[0].target, 1. / 30.);
  EXPECT_EQ(back.accuracy.quantities[1].quantity, "teeth_in_contact_per_wave");
  EXPECT_FALSE(back.accuracy.quantities[1].target);
  ASSERT_EQ(back.output.history_points.size(), 2u);
  EXPECT_EQ(back.output.history_points[1].tooth, 100. / 7.);
  EXPECT_EQ(back.output.history_points[1].radius, 1. / 29.);
  EXPECT_EQ(back.modes.nodal_diameters, parameters.modes.nodal_diameters);
  EXPECT_EQ(back.effects["Rotor inertia"], EffectChoice::automatic);
  EXPECT_FALSE(back.output.vtu);

  EXPECT_NE(text.find("= 0.0342\n"), std::string::npos);
  EXPECT_NE(text.find("= 5e-07\n"), std::string::npos);
  EXPECT_NE(text.find("= 0, 2-4, 9, 44-45\n"), std::string::npos);
}

TEST(Reading, NodalDiametersAsListRangesAndAll)
{
  using Numbers      = std::vector<unsigned int>;
  const auto numbers = [](const std::string &text)
  { return nodal_diameters_of(with({"Modes/Nodal diameters = " + text})); };
  EXPECT_EQ(numbers("7"), Numbers{7});
  EXPECT_EQ(numbers("2, 5-7"), (Numbers{2, 5, 6, 7}));
  EXPECT_EQ(numbers("5 - 7,6, 2 "), (Numbers{2, 5, 6, 7}));
  Numbers expected(13);
  std::iota(expected.begin(), expected.end(), 0);
  EXPECT_EQ(numbers("0-12"), expected);

  EXPECT_EQ(numbers("all").size(), 46u);
  EXPECT_EQ(numbers("all").back(), 45u);
  const Parameters odd = with({"Motor/Number of teeth = 15", "Modes/Nodal diameters = all"});
  EXPECT_EQ(nodal_diameters_of(odd), (Numbers{0, 1, 2, 3, 4, 5, 6, 7}));
  EXPECT_EQ(numbers("wave"), Numbers{7});
  EXPECT_EQ(nodal_diameters_of(with({"Motor/Number of waves = 5"})), Numbers{5});
}

TEST(Reading, SkipsAByteOrderMark)
{
  EXPECT_EQ(printed(read_parameters_from_text("\xEF\xBB\xBF" + complete_text(), "a.prm")),
            printed(read_parameters_from_text(complete_text(), "a.prm")));
}

TEST(Reading, NamesInAllLanguages)
{
  for (const std::string name : {"Motor f\u00FCr \"77\", \u00D8 60\u00A0mm",
                                 "\u8D85\u58F0\u6CE2\u7535\u673A \u2116 1", "$x 'y' ~z"})
  {
    const Parameters parameters = with({"Motor/Name = " + name});
    EXPECT_EQ(parameters.motor.name, name);
    EXPECT_EQ(read_parameters_from_text(printed(parameters), "a.prm").motor.name, name);
  }
}

TEST(Reading, MessagesAreCutBetweenCharacters)
{
  std::string text;
  for (unsigned int i = 0; i < 81; ++i)
    text += "\u8D85";
  EXPECT_EQ(in_quotes(text), '"' + text.substr(0, 240) + "...\"");
  EXPECT_EQ(in_quotes("a\u200B\x1B\u009B\xFC"), "\"a????\"");
}

TEST(Reading, OverridesWinOverTheFile)
{
  const Parameters parameters =
      with({"Wave/Amplitude = 3e-6", "Materials/Stator metal/Density=7850",
            " Loading / Values = 0, 0.05", "Wave/Frequency = 31000", "Motor/Name = a = b"});
  EXPECT_EQ(parameters.wave.amplitude, 3e-6);
  EXPECT_EQ(parameters.materials.stator_metal.density, 7850.);
  EXPECT_EQ(parameters.loading.values, (std::vector<double>{0., 0.05}));
  EXPECT_EQ(parameters.wave.frequency, 31000.);
  EXPECT_EQ(parameters.motor.name, "a = b");
}

TEST(Reading, CommentsBlanksContinuationAndLineEndings)
{
  std::string text  = complete_text();
  const auto begin  = text.find("subsection Wave");
  const auto length = text.find("subsection Loading") - begin;
  text.replace(begin, length,
               "subsection  Wave # a comment does not join lines \\\r\n"
               "\tset   Amplitude=\\\r\n"
               "    4e-6 # zero to peak\r\n"
               "end\r\n"
               "subsection Wave\n"
               "set Frequency = \\\n"
               "  mode\n"
               "end # Wave\n");
  const Parameters parameters = read_parameters_from_text(text, "spaced.prm");
  EXPECT_EQ(parameters.wave.amplitude, 4e-6);
  EXPECT_FALSE(parameters.wave.frequency.has_value());

  std::string of_old_macintosh = complete_text();
  std::replace(of_old_macintosh.begin(), of_old_macintosh.end(), '\n', '\r');
  EXPECT_EQ(printed(read_parameters_from_text(of_old_macintosh, "a.prm")),
            printed(read_parameters_from_text(complete_text(), "a.prm")));
}

TEST(Reading, AMeshFileReplacesTheStatorDimensions)
{
  const auto folder = std::filesystem::temp_directory_path() /
                      ("ringmotor_test_reading_" + std::to_string(getpid()));
  std::filesystem::create_directories(folder / "meshes");
  std::ofstream(folder / "meshes" / "sector.msh") << "a mesh";
  std::ofstream(folder / "motor.prm") << "subsection Motor\n"
                                         "set Number of waves = 7\n"
                                         "set Number of teeth = 90\n"
                                         "end\n"
                                         "subsection Stator\n"
                                         "set Mesh file = meshes/sector.msh\n"
                                         "end\n"
                                         "subsection Materials\n"
                                         "subsection Stator metal\n"
                                         "set Young modulus = 1e11\n"
                                         "set Poisson ratio = 0.3\n"
                                         "set Density = 8000\n"
                                         "end\n"
                                         "subsection Piezoceramic\n"
                                         "set Young modulus = 1e11\n"
                                         "set Poisson ratio = 0.3\n"
                                         "set Density = 8000\n"
                                         "end\n"
                                         "end\n"
                                         "subsection Wave\n"
                                         "set Amplitude = 1e-6\n"
                                         "end\n";
  const std::string file = (folder / "motor.prm").string();

  // Beside the parameter file, whatever the current directory is.
  const Parameters parameters = read_parameters(file);
  EXPECT_EQ(parameters.stator.mesh_file, (folder / "meshes" / "sector.msh").string());
  EXPECT_NO_THROW(check_for_stator(parameters));

  // Only then in the current directory.
  const auto former_folder = std::filesystem::current_path();
  std::filesystem::create_directories(folder / "here");
  std::ofstream(folder / "here" / "other.msh") << "a mesh";
  std::filesystem::current_path(folder / "here");
  std::filesystem::create_directories("meshes");
  std::ofstream("meshes/sector.msh") << "another mesh";
  EXPECT_EQ(read_parameters(file).stator.mesh_file, (folder / "meshes" / "sector.msh").string());
  EXPECT_EQ(read_parameters(file, {"Stator/Mesh file = other.msh"}).stator.mesh_file,
            (folder / "here" / "other.msh").string());
  std::filesystem::current_path(former_folder);
  std::filesystem::remove_all(folder);
}

TEST(Reading, EveryEntryExplainsItselfInHelp)
{
  std::istringstream text(complete_text());
  bool explained = false;
  for (std::string line; std::getline(text, line);)
  {
    if (line.find("  # ") != std::string::npos)
      explained = true;
    else if (line.find(" set ") != std::string::npos)
    {
      EXPECT_TRUE(explained) << line;
      explained = false;
    }
  }
}
