// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What the program contact keeps for later runs: it is reused only under the same circumstances,
// and then bit for bit the same.

#include "parameters/sample.h"
#include "scratch.h"
#include "support/motor_model.h"

#include <ringmotor/motor/relevant.h>
#include <ringmotor/motor/stator_modes.h>
#include <ringmotor/output/contact_keep.h>
#include <ringmotor/output/files.h>
#include <ringmotor/output/kept_file.h>
#include <ringmotor/parameters/entries.h>
#include <ringmotor/parameters/prm_file.h>
#include <ringmotor/points/point_source.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

using namespace ringmotor;
using namespace ringmotor::tests;
using ringmotor::sample::changed;
using ringmotor::sample::with;

namespace
{
  StatorWave some_wave()
  {
    StatorWave wave;
    wave.fingerprint = "wave";
    return wave;
  }

  // Entries that affect no single operating point, and those that do not affect the condensed
  // motor: this list is a promise to the user, who may change them and still resume.
  const std::set<std::string> not_of_points{
      "Motor/Name", "Motor/Unusual values", "Loading/Control", "Loading/Values",
      "Loading/Number of curve points", "Accuracy/Contact target", "Accuracy/Quantities",
      "Accuracy/Mode", "Accuracy/Time limit", "Accuracy/Interface refinement",
      "Accuracy/Rotor modes", "Output/Directory", "Output/VTU", "Output/Frames per period",
      "Output/Figures", "Output/History points", "Modes/Body", "Modes/Domain",
      "Modes/Nodal diameters", "Modes/Number of modes", "Modes/Frequency target",
      "Materials/Stator metal/Loss factor", "Materials/Piezoceramic/Loss factor",
      "Materials/Rotor metal/Loss factor", "Materials/Target plate/Loss factor",
      "Support/Felt thickness", "Support/Felt modulus", "Support/Felt loss factor",
      "Support/Felt inner radius", "Support/Felt outer radius", "Uncertainty/Loss factors",
      "Uncertainty/Friction", "Uncertainty/Young moduli",
      // of motors from sections
      "Stator/Slot angle", "Rotor/Shell thickness", "Materials/Lining/Young modulus",
      "Materials/Lining/Poisson ratio", "Materials/Lining/Density", "Materials/Lining/Loss factor",
      "Materials/Adhesive/Young modulus", "Materials/Adhesive/Poisson ratio",
      "Materials/Adhesive/Density", "Materials/Adhesive/Loss factor",
      // entries of effects that are off
      "Stator/Target plate cross-section", "Materials/Target plate/Young modulus",
      "Materials/Target plate/Poisson ratio", "Materials/Target plate/Density",
      "Piezoelectricity/Stiffness c11", "Piezoelectricity/Stiffness c12",
      "Piezoelectricity/Stiffness c13", "Piezoelectricity/Stiffness c33",
      "Piezoelectricity/Stiffness c44", "Piezoelectricity/Coupling form",
      "Piezoelectricity/Coupling 31", "Piezoelectricity/Coupling 33",
      "Piezoelectricity/Coupling 15", "Piezoelectricity/Permittivity at",
      "Piezoelectricity/Permittivity 11", "Piezoelectricity/Permittivity 33",
      "Piezoelectricity/Dielectric loss factor", "Piezoelectricity/Piezoelectric loss factor",
      "Electrodes/Arcs of phase A", "Electrodes/Arcs of phase B", "Electrodes/Distance of phases",
      "Electrodes/Gap between arcs", "Wave/Voltage", "Wave/Response torques",
      "Friction/Lining normal stiffness", "Friction/Lining tangential stiffness"};
  const std::set<std::string> not_of_condensation{"Wave/Drive",
                                                  "Loading/Preload",
                                                  "Friction/Law",
                                                  "Friction/Static coefficient",
                                                  "Friction/Dynamic coefficient",
                                                  "Friction/Decay velocity",
                                                  "Friction/Weakening length",
                                                  "Initial deformation/Amplitude",
                                                  "Initial deformation/Number of waves",
                                                  "Time/Scheme",
                                                  "Time/Time step",
                                                  "Time/Number of steps",
                                                  "Time/Average from step",
                                                  "Time/Average to step",
                                                  "Time/Snapshots",
                                                  "Time/Spectral radius"};
} // namespace

TEST(ContactKeepKeys, HoldEveryEntryButThoseThatMakeNoDifference)
{
  const StatorWave wave      = some_wave();
  const Parameters reference = with({});
  const auto assignments     = parse_prm(text_of(reference), "reference").assignments;
  EXPECT_GT(assignments.size(), 80u);
  for (const PrmFile::Assignment &assignment : assignments)
  {
    const std::string change = changed(assignment.path);
    ASSERT_NE(change, "") << assignment.path << ": the test knows no other value";
    const bool of_points       = not_of_points.count(assignment.path) == 0,
               of_condensation = of_points && not_of_condensation.count(assignment.path) == 0;
    const Parameters other     = with({change});
    EXPECT_EQ(points_key(other, wave, 1) != points_key(reference, wave, 1), of_points) << change;
    EXPECT_EQ(condensation_key(other, wave, 1) != condensation_key(reference, wave, 1),
              of_condensation)
        << change;
  }
}

TEST(ContactKeepKeys, HoldTheTargetThatMarchedPointsSettleTo)
{
  const StatorWave wave   = some_wave();
  const std::string warp  = "Initial deformation/Amplitude = 4e-6";
  const Parameters warped = with({warp}), other = with({warp, "Accuracy/Contact target = 0.01"});
  EXPECT_NE(points_key(warped, wave, 1), points_key(other, wave, 1));
  EXPECT_EQ(condensation_key(warped, wave, 1), condensation_key(other, wave, 1));
}

TEST(ContactKeepKeys, HoldTheCeramicWhereItHasAPotential)
{
  const StatorWave wave = some_wave();
  const auto key        = [&](const std::string &entry) {
    return points_key(with({"Effects/Piezoelectric coupling = on", entry}), wave, 1);
  };
  const std::string reference = key("Motor/Name = other");
  EXPECT_NE(key("Piezoelectricity/Stiffness c11 = 140e9"), reference);
  EXPECT_NE(key("Piezoelectricity/Coupling 31 = -5"), reference);
  EXPECT_EQ(key("Piezoelectricity/Dielectric loss factor = 0.01"), reference);
  EXPECT_EQ(key("Electrodes/Arcs of phase A = 4"), reference);
}

TEST(ContactKeepKeys, HoldTheDriveOfADrivenWave)
{
  const std::vector<std::string> driven{"Effects/Piezoelectric coupling = on",
                                        "Wave/Drive = voltage"};
  StatorWave wave = some_wave();
  wave.drive.emplace();
  const auto parameters = [&](const std::string &voltage)
  {
    std::vector<std::string> all = driven;
    all.push_back("Wave/Voltage = " + voltage);
    return with(all);
  };
  const std::string reference    = points_key(parameters("20"), wave, 1),
                    of_condensed = condensation_key(parameters("20"), wave, 1);
  EXPECT_NE(points_key(parameters("21"), wave, 1), reference);
  EXPECT_EQ(condensation_key(parameters("21"), wave, 1), of_condensed);
  wave.drive->internal_loss = 1.;
  EXPECT_NE(points_key(parameters("20"), wave, 1), reference);
  EXPECT_EQ(condensation_key(parameters("20"), wave, 1), of_condensed);
}

TEST(ContactKeepKeys, HoldTheLiningWhereItTakesPart)
{
  const StatorWave wave = some_wave();
  const std::vector<std::string> lining{"Effects/Friction lining = on",
                                        "Friction/Lining tangential stiffness = 1e13"};
  const auto key = [&](const std::string &normal_stiffness)
  {
    std::vector<std::string> all = lining;
    all.push_back("Friction/Lining normal stiffness = " + normal_stiffness);
    return condensation_key(with(all), wave, 1);
  };
  EXPECT_NE(key("1e13"), key("2e13"));
}

TEST(ContactKeepKeys, HoldWhatARotorWithInertiaVibratesBy)
{
  const StatorWave wave       = some_wave();
  const std::string inertia   = "Effects/Rotor inertia = on";
  const std::string reference = condensation_key(with({inertia}), wave, 1);
  for (const std::string change :
       {"Time/Spectral radius = 0.3", "Materials/Rotor metal/Loss factor = 0.01",
        "Effects/Damping = on"})
    EXPECT_NE(condensation_key(with({inertia, change}), wave, 1), reference) << change;
}

TEST(ContactKeepKeys, HoldWaveAndInterfaceMesh)
{
  const Parameters parameters = with({});
  const StatorWave wave       = some_wave();
  StatorWave other_wave       = wave;
  other_wave.fingerprint      = "other";
  const std::set<std::string> keys{condensation_key(parameters, wave, 1),
                                   condensation_key(parameters, wave, 2),
                                   condensation_key(parameters, other_wave, 1),
                                   points_key(parameters, wave, 1),
                                   points_key(parameters, wave, 2),
                                   points_key(parameters, other_wave, 1)};
  EXPECT_EQ(keys.size(), 6u);
}

TEST(ContactKeepKeys, HoldTheContentOfMeshFiles)
{
  const Scratch scratch;
  const std::string mesh = scratch.path("sector.msh");
  const auto key         = [&](const std::string &content)
  {
    std::ofstream(mesh) << content;
    return condensation_key(with({"Rotor/Mesh file = " + mesh}), some_wave(), 1);
  };
  const std::string first = key("one mesh");
  EXPECT_NE(key("two mesh"), first);
  EXPECT_EQ(key("one mesh"), first);
}

namespace
{
  class ContactKeepFiles : public testing::Test
  {
  protected:
    static void SetUpTestSuite()
    {
      Parameters stator      = reference_motor();
      stator.accuracy.target = 1e-2;
      wave                   = std::make_unique<StatorWave>(stator_wave(stator));
    }
    static void TearDownTestSuite() { wave.reset(); }

    ContactKeepFiles()
    {
      parameters                 = reference_motor();
      parameters.accuracy.target = 1e-2;
    }

    ContactKeep keep(const bool resumes)
    {
      return ContactKeep(scratch.path(""), parameters, *wave, resumes, log, MPI_COMM_SELF);
    }

    /** The bytes of a motor, and the log's text. */
    std::pair<std::string, std::string> motor()
    {
      said.str("");
      const CondensedMotor motor = condensed(keep(false));
      return {to_bytes(motor), said.str()};
    }

    CondensedMotor condensed(ContactKeep store)
    {
      Progress silent;
      const MotorVibration vibration(parameters, *wave);
      return ComputedPoints(parameters, *wave, vibration, store, silent, MPI_COMM_SELF)
          .motors({0}, RotorVibration::usual_level)
          .front()
          .motor;
    }

    /** The points of requests on the coarsest mesh. */
    std::vector<CurvePoint> points(ContactKeep &store, const CondensedMotor &motor,
                                   const std::vector<PointRequest> &wanted)
    {
      Progress silent;
      const MotorVibration vibration(parameters, *wave);
      return ComputedPoints(parameters, *wave, vibration, store, silent, MPI_COMM_SELF)
          .points({{{}, motor, wanted, {}}})
          .front();
    }

    static std::string without_seconds(std::vector<CurvePoint> points)
    {
      for (CurvePoint &point : points)
        point.seconds = 0.;
      return to_bytes(points);
    }

    static std::unique_ptr<StatorWave> wave;
    const Scratch scratch;
    Parameters parameters = paper_motor();
    std::ostringstream said;
    Log log{true, said, false};
    const std::vector<PointRequest> requests{
        {Control::torque, 0.}, {Control::torque, 0.1}, {Control::speed, 0.}};
  };

  std::unique_ptr<StatorWave> ContactKeepFiles::wave;

  void damage(const std::string &path, const double place)
  {
    std::string content = content_of(path);
    content[static_cast<std::size_t>(place * (content.size() - 1))] ^= 0x10;
    std::ofstream(path, std::ios::binary) << content;
  }
} // namespace

TEST_F(ContactKeepFiles, GiveBackTheSameMotor)
{
  const auto [computed, said_first] = motor();
  EXPECT_EQ(said_first, "");
  EXPECT_EQ(computed, to_bytes(condense_motor(parameters, *wave, ContactDiscretisation::level(0))));
  const auto [read, said_then] = motor();
  EXPECT_TRUE(read == computed);
  EXPECT_NE(said_then.find("condensation of interface mesh 0 read from"), std::string::npos);
}

TEST_F(ContactKeepFiles, NeverGiveADamagedMotorOrThatOfAnother)
{
  const std::string path = scratch.path("/kept/interface_mesh_0"), computed = motor().first;
  for (const double place : {0., 0.5, 1.})
  {
    damage(path, place);
    const auto [bytes, said] = motor();
    EXPECT_TRUE(bytes == computed) << place;
    EXPECT_NE(said.find("is damaged: computed anew"), std::string::npos) << said;
  }
  parameters.rotor.flange_thickness *= 1.01;
  const auto [bytes, said] = motor();
  EXPECT_FALSE(bytes == computed);
  EXPECT_NE(said.find("belongs to other parameters or another version: computed anew"),
            std::string::npos)
      << said;
  EXPECT_NE(motor().second.find("read from"), std::string::npos) << "the new one is kept";
}

// The remaining points start from the last existing one, as if it had just been computed.
TEST_F(ContactKeepFiles, PointsThatAreMissingComeOutTheSameToTheLastBit)
{
  parameters.friction.law                = FrictionLaw("static-dynamic");
  parameters.friction.static_coefficient = 0.48;
  const CondensedMotor motor             = condensed(keep(false));
  for (const unsigned int n_left : {1u, 2u, 3u})
  {
    const auto first = [&](ContactKeep store, const unsigned int n) {
      return without_seconds(points(store, motor, {requests.begin(), requests.begin() + n}));
    };
    const std::string whole = first(keep(false), 3);
    first(keep(false), n_left);
    EXPECT_TRUE(first(keep(true), 3) == whole) << n_left;
  }
}

TEST_F(ContactKeepFiles, PointsAreThereUnlessDamagedOrOfAnotherLoad)
{
  const CondensedMotor motor = condensed(keep(false));
  const auto report          = [&]()
  {
    said.str("");
    ContactKeep store = keep(true);
    points(store, motor, requests);
    store.report();
    return said.str().substr(said.str().find('\n'));
  };
  ContactKeep first = keep(false);
  points(first, motor, requests);
  EXPECT_NE(report().find("3 operating points, including those for error bars, were available; "
                          "nothing was left to compute"),
            std::string::npos);
  for (const auto &entry : std::filesystem::directory_iterator(scratch.path("/kept/points")))
    damage(entry.path(), 0.7);
  EXPECT_NE(report().find("3 kept operating points were damaged: computed anew"),
            std::string::npos);
  EXPECT_NE(report().find("nothing was left"), std::string::npos);
  parameters.loading.preload = 15.;
  EXPECT_NE(report().find(" 0 operating points, including those for error bars, were available; "
                          "3 were computed"),
            std::string::npos);
  keep(false);
  EXPECT_NE(report().find("3 were computed"), std::string::npos) << "a new start forgets them";
}
