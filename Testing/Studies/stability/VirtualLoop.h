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
/// What a loop makes of a reading. Device frame, m and N.
class Rendering
{
public:
  Rendering() = default;
  Rendering(const Rendering&) = delete;
  Rendering& operator=(const Rendering&) = delete;
  virtual ~Rendering() = default;
  virtual Eigen::Vector3d force(const DeviceSample& sample, double time) noexcept = 0;
  /// s: for so long the device holds the last force when no other comes; by default as long as the
  /// protocol's watchdog of a device whose time-out is the usual one.
  virtual double holdTime() const noexcept { return 0.02; }
  /// Whether the last reading was outside of the body.
  virtual bool isFree() const noexcept = 0;
};

/// The device and the hand on it.
struct LoopSetting
{
  SimulatedPlant plant;
  HandModel hand;
  /// N, along -z: on the mass whatever it does, as a weight; beside the hand. It goes to the device
  /// with the motor's force: not to be used with faults.
  double push = 0.0;
  double rate = 1000.0; ///< Hz
  /// s: the bound that the device states of how late it is.
  double statedDelay = 0.0;
  /// s: from when to when the host does nothing; the device lets go by itself.
  double hostStalls = 0.0;
  double hostGoesOn = 0.0;

  double period() const { return 1.0 / this->rate; }
  /// The stiffest spring that the device's own damping allows, 2b/T, N/m (Colgate and Schenkel).
  double passiveStiffness() const { return 2.0 * this->plant.damping * this->rate; }
  /// It renders b/T and twice the strongest push of the study, and states its delay.
  DeviceSpecification specification() const;
  /// Ticks after which 0.5 % of stiffness, more or less than critical, has changed a swing by 10 %:
  /// near its limit a light damped mass grows by (K/K* - 1) bT/2m per tick.
  int watchedTicks() const;
};

constexpr double StrongestPush = 10.0; // N
constexpr HandModel Nobody{ 0.0, 0.0 };

/**
 * A simulated device in a hand, and a rendering, closed to a loop in virtual time. `rendering` must
 * outlive it.
 */
class VirtualLoop
{
public:
  VirtualLoop(const LoopSetting& setting, std::vector<WayPoint> path, Rendering& rendering,
    const DeviceFaults& faults = {});

  void tick();
  void run(int ticks);
  /// Runs, and gives the largest |v| (m/s) at the ticks.
  double peakSpeed(int ticks);
  /// Runs, and gives the heights z (m) at the ticks.
  std::vector<double> heights(int ticks);
  /// Runs, and gives max z - min z, m.
  double swing(int ticks);

  double time() const noexcept { return this->Time; } ///< of the next tick, s
  Eigen::Vector3d position() const noexcept { return this->Device->truePosition(); } ///< m
  Eigen::Vector3d velocity() const noexcept { return this->Device->trueVelocity(); } ///< m/s
  const Eigen::Vector3d& force() const noexcept { return this->Force; } ///< asked of the device, N
  /// What the motor really does.
  const Eigen::Vector3d& acting() const noexcept { return this->Acting; }
  double peakForce() const noexcept { return this->Peak; } ///< N, of acting
  int notFinite() const noexcept { return this->Bad; }     ///< forces written that were no number
  const EnergyAudit& audit() const noexcept { return this->Audit; }
  void forgetPeaks() noexcept;

private:
  LoopSetting Setting;
  std::unique_ptr<HapticDevice> Port; ///< the device, or faults around it
  SimulatedDevice* Device;
  Rendering& Rendered;
  EnergyAudit Audit;
  double Time = 0.0;
  int Ticks = 0;
  double ToldTime = 0.0; ///< when a force was told last
  Eigen::Vector3d Force = Eigen::Vector3d::Zero();
  Eigen::Vector3d Acting = Eigen::Vector3d::Zero();
  double Peak = 0.0;
  int Bad = 0;
};
} // namespace palpate::testing

#endif
