// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_VirtualLoop_h
#define palpate_testing_VirtualLoop_h

#include "Haptics/Simulation/DeviceFaults.h"
#include "EnergyAudit.h"
#include "Haptics/Devices/HapticDevice.h"
#include "Haptics/Simulation/SimulatedDevice.h"

#include <Eigen/Core>

#include <memory>
#include <vector>

namespace palpate::testing
{
/// Computes a force from a reading. Device frame, m and N.
class Rendering
{
public:
  Rendering() = default;
  Rendering(const Rendering&) = delete;
  Rendering& operator=(const Rendering&) = delete;
  virtual ~Rendering() = default;
  virtual Eigen::Vector3d force(const DeviceSample& sample, double time) noexcept = 0;
  /// s, time for which the device holds the last force if no other force comes. The default is the
  /// watchdog time of the protocol for a device with the usual time-out.
  virtual double holdTime() const noexcept { return 0.02; }
  /// True if the last reading was outside the body.
  virtual bool isFree() const noexcept = 0;
};

/// The device and the hand on it.
struct LoopSetting
{
  SimulatedPlant plant;
  HandModel hand;
  /// N, along -z: a constant force on the mass, like a weight, in addition to the hand. It is sent
  /// to the device together with the motor's force, so it must not be used with faults.
  double push = 0.0;
  double rate = 1000.0; ///< Hz
  /// s, bound of its delay that the device states.
  double statedDelay = 0.0;
  /// s, begin and end of the time in which the host does nothing. The device then ends the force
  /// itself.
  double hostStalls = 0.0;
  double hostGoesOn = 0.0;

  double period() const { return 1.0 / this->rate; }
  /// The stiffest spring that the device's own damping allows, 2b/T, N/m (Colgate and Schenkel).
  double passiveStiffness() const { return 2.0 * this->plant.damping * this->rate; }
  /// The device renders b/T and twice the strongest push of the study, and states its delay.
  DeviceSpecification specification() const;
  /// Number of ticks in which a stiffness 0.5 % above or below the critical one changes a swing by
  /// 10 %: near the limit the swing of a lightly damped mass grows by (K/K* - 1) bT/2m per tick.
  int watchedTicks() const;
};

constexpr double StrongestPush = 10.0; // N
constexpr HandModel Nobody{ 0.0, 0.0 };

/**
 * A closed loop of a simulated device in a hand and a rendering, in virtual time. `rendering` must
 * outlive the loop.
 */
class VirtualLoop
{
public:
  VirtualLoop(const LoopSetting& setting, std::vector<WayPoint> path, Rendering& rendering,
    const DeviceFaults& faults = {});

  void tick();
  void run(int ticks);
  /// Runs the loop and returns the largest |v| (m/s) at the ticks.
  double peakSpeed(int ticks);
  /// Runs the loop and returns the heights z (m) at the ticks.
  std::vector<double> heights(int ticks);
  /// Runs the loop and returns max z - min z, m.
  double swing(int ticks);

  double time() const noexcept { return this->Time; } ///< time of the next tick, s
  Eigen::Vector3d position() const noexcept { return this->Device->truePosition(); } ///< m
  Eigen::Vector3d velocity() const noexcept { return this->Device->trueVelocity(); } ///< m/s
  const Eigen::Vector3d& force() const noexcept { return this->Force; } ///< sent to the device, N
  /// The force that acts at the motor.
  const Eigen::Vector3d& acting() const noexcept { return this->Acting; }
  double peakForce() const noexcept { return this->Peak; } ///< N, of acting
  int notFinite() const noexcept { return this->Bad; }     ///< written forces that were not finite
  const EnergyAudit& audit() const noexcept { return this->Audit; }
  void forgetPeaks() noexcept;

private:
  LoopSetting Setting;
  std::unique_ptr<HapticDevice> Port; ///< the device, possibly wrapped in faults
  SimulatedDevice* Device;
  Rendering& Rendered;
  EnergyAudit Audit;
  double Time = 0.0;
  int Ticks = 0;
  double ToldTime = 0.0; ///< time of the last force
  Eigen::Vector3d Force = Eigen::Vector3d::Zero();
  Eigen::Vector3d Acting = Eigen::Vector3d::Zero();
  double Peak = 0.0;
  int Bad = 0;
};
} // namespace palpate::testing

#endif
