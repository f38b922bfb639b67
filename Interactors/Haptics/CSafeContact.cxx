// SPDX-License-Identifier: BSD-3-Clause
// The part of palpate.h with mapping and safety.
#include "Haptics/CInterface.h"

#include "Haptics/Safety/SafetySettings.h"

#include <Eigen/Geometry>

#include <cmath>
#include <exception>
#include <iterator>

namespace
{
using palpate::c::copy;
using palpate::c::given;
using palpate::c::isFromLater;
using palpate::c::isRefused;
using palpate::c::report;

palpate::WorkspaceMapping given(const palpate_mapping& mapping)
{
  using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
  const palpate::WorkspaceMapping spatial(Eigen::Map<const RowMajor>(mapping.rotation),
    Eigen::Map<const Eigen::Vector3d>(mapping.translation), mapping.scale);
  return mapping.planar != 0 ? spatial.planar() : spatial;
}

palpate::SafetySettings given(const palpate_safety& safety)
{
  palpate::SafetySettings given;
  given.gate = safety.gate != 0;
  given.entryRamp = safety.entry_ramp;
  given.forceFactor = safety.force_factor;
  given.capStiffness = safety.cap_stiffness != 0;
  given.maximumStiffness = safety.maximum_stiffness;
  given.maximumForceRate = safety.maximum_force_rate;
  given.maximumForce = safety.maximum_force;
  given.controlPassivity = safety.control_passivity != 0;
  given.period = safety.period;
  given.sampleTimeOut = safety.sample_time_out;
  given.delay = safety.delay;
  given.maximumTorque = safety.maximum_torque;
  if (safety.maximum_torsional_stiffness != 0.0)
  {
    given.maximumTorsionalStiffness = safety.maximum_torsional_stiffness;
  }
  if (safety.maximum_torque_rate != 0.0)
  {
    given.maximumTorqueRate = safety.maximum_torque_rate;
  }
  return given;
}

/// Returns the bounding box of the surface that can be touched. The box is empty (lower corner
/// above upper corner) if there is no such surface.
Eigen::AlignedBox3d boxOf(const palpate::PackedMesh& surface)
{
  Eigen::AlignedBox3d box;
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(surface.triangleCount()); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      box.extend(surface.corner(i, k) + surface.centre());
    }
  }
  return box;
}

/// Converts a scene to the opaque palpate_scene of the C interface.
palpate_scene* handleOf(std::unique_ptr<palpate::ServoScene> scene)
{
  return reinterpret_cast<palpate_scene*>(scene.release());
}

std::unique_ptr<palpate::ServoScene> sceneOf(palpate_scene* handle)
{
  return std::unique_ptr<palpate::ServoScene>(reinterpret_cast<palpate::ServoScene*>(handle));
}

/// Creates a scene. Returns null on failure and writes the reason to `error`.
std::unique_ptr<palpate::ServoScene> makeScene(const palpate_body* body,
  const palpate_settings* settings, double forceFactor, char* error, std::size_t size)
{
  const palpate::ContactSettings wanted = settings ? given(*settings) : palpate::ContactSettings();
  if (!body)
  {
    report("no body is given", error, size);
    return nullptr;
  }
  if ((settings && isFromLater(settings->reserved, "palpate_settings", error, size)) ||
    isRefused(palpate::faultOfContact(wanted), error, size) ||
    isRefused(palpate::faultOfForceFactor(forceFactor), error, size))
  {
    return nullptr;
  }
  return std::make_unique<palpate::ServoScene>(body->kernel, wanted, forceFactor);
}
} // namespace

void palpate_mapping_default(palpate_mapping* mapping)
{
  *mapping = { { 1, 0, 0, 0, 1, 0, 0, 0, 1 }, { 0, 0, 0 }, 1.0, 0, {} };
}

int palpate_mapping_fit(palpate_mapping* mapping, const palpate_body* body,
  const double workspace[3], double margin, char* error, size_t error_size)
{
  const Eigen::AlignedBox3d box = body ? boxOf(body->kernel->surface) : Eigen::AlignedBox3d();
  const Eigen::Map<const Eigen::Vector3d> reach(workspace);
  const bool hasReach = reach[0] > 0.0 && reach[1] > 0.0 && (mapping->planar || reach[2] > 0.0);
  if (box.isEmpty())
  {
    report(body ? "the body has no triangle" : "no body is given", error, error_size);
    return 0;
  }
  if (!hasReach || !reach.allFinite())
  {
    report("workspace must be finite and positive (m)", error, error_size);
    return 0;
  }
  if (!(margin >= 0.0) || !std::isfinite(margin))
  {
    report("margin must be finite and not negative (mm), but is " + std::to_string(margin), error,
      error_size);
    return 0;
  }
  if (isFromLater(mapping->reserved, "palpate_mapping", error, error_size))
  {
    return 0;
  }
  palpate::WorkspaceMapping turned = given(*mapping);
  const palpate::WorkspaceMapping fit = turned.fitted(box.min(), box.max(), reach, margin);
  if (isRefused(fit.fault(), error, error_size))
  {
    return 0;
  }
  copy(fit.translation(), mapping->translation);
  mapping->scale = fit.scale();
  return 1;
}

void palpate_device_default(palpate_device* device)
{
  const palpate::DeviceSpecification usual;
  *device = {};
  device->maximum_force = usual.maximumForce;
  device->maximum_stiffness = usual.maximumStiffness;
  device->maximum_force_rate = usual.maximumForceRate;
  device->rate = usual.rate;
  device->sample_time_out = usual.sampleTimeOut;
}

void palpate_safety_of(const palpate_device* device, palpate_safety* safety)
{
  palpate::DeviceSpecification specification;
  if (device)
  {
    specification.maximumForce = device->maximum_force;
    specification.maximumStiffness = device->maximum_stiffness;
    specification.maximumForceRate = device->maximum_force_rate;
    specification.rate = device->rate;
    specification.sampleTimeOut = device->sample_time_out;
    specification.delay = device->delay;
    specification.outputsTorque = device->maximum_torque != 0.0;
    specification.maximumTorque = device->maximum_torque;
    if (device->maximum_torsional_stiffness != 0.0)
    {
      specification.maximumTorsionalStiffness = device->maximum_torsional_stiffness;
    }
  }
  const palpate::SafetySettings settings = palpate::SafetySettings::of(specification);
  *safety = {};
  safety->gate = settings.gate;
  safety->entry_ramp = settings.entryRamp;
  safety->force_factor = settings.forceFactor;
  safety->cap_stiffness = settings.capStiffness;
  safety->maximum_stiffness = settings.maximumStiffness;
  safety->maximum_force_rate = settings.maximumForceRate;
  safety->maximum_force = settings.maximumForce;
  safety->control_passivity = settings.controlPassivity;
  safety->period = settings.period;
  safety->sample_time_out = settings.sampleTimeOut;
  safety->delay = settings.delay;
  if (settings.maximumTorque != 0.0)
  {
    safety->maximum_torque = settings.maximumTorque;
    safety->maximum_torsional_stiffness = settings.maximumTorsionalStiffness;
  }
}

palpate_contact* palpate_contact_new_safe(const palpate_body* body, const palpate_mapping* mapping,
  const palpate_safety* safety, const palpate_settings* settings, unsigned int clutch_buttons,
  char* error, size_t error_size)
{
  try
  {
    const palpate::WorkspaceMapping place = mapping ? given(*mapping) : palpate::WorkspaceMapping();
    if (!safety)
    {
      report("no safety is given", error, error_size);
    }
    else if (!(mapping && isFromLater(mapping->reserved, "palpate_mapping", error, error_size)) &&
      !isFromLater(safety->reserved, "palpate_safety", error, error_size) &&
      !isRefused(place.fault(), error, error_size) &&
      !isRefused(palpate::faultOf(given(*safety)), error, error_size))
    {
      auto scene = makeScene(body, settings, 1.0, error, error_size);
      return scene ? new palpate_contact{ palpate::ServoStep(
                       std::move(scene), place, given(*safety), clutch_buttons) }
                   : nullptr;
    }
  }
  catch (const std::exception& failure)
  {
    report(std::string("cannot make the contact: ") + failure.what(), error, error_size);
  }
  return nullptr;
}

void palpate_sample_default(palpate_sample* sample)
{
  *sample = { { 0, 0, 0 }, { 0, 0, 0 }, 0, 1, 1, { 0, 0, 0, 0 }, { 0, 0, 0 }, {} };
}

void palpate_step_sample(
  palpate_contact* contact, const palpate_sample* sample, double time, palpate_full_tick* tick)
{
  palpate::DeviceSample reading;
  reading.position = Eigen::Map<const Eigen::Vector3d>(sample->position);
  reading.velocity = Eigen::Map<const Eigen::Vector3d>(sample->velocity);
  reading.buttons = sample->buttons;
  reading.valid = sample->valid != 0;
  reading.fresh = sample->fresh != 0;
  const double* const turn = sample->orientation;
  reading.orientation = palpate::ToolOrientation(turn[0], turn[1], turn[2], turn[3]);
  reading.angularVelocity = Eigen::Map<const Eigen::Vector3d>(sample->angular_velocity);
  const palpate::Tick felt = contact->servo.step(reading, time);
  copy(felt, &tick->tick);
  copy(felt.velocity, tick->velocity);
  copy(felt.idealForce, tick->ideal_force);
  copy(felt.appliedForce, tick->applied_force);
  tick->force_factor = felt.forceFactor;
  tick->scene_share = felt.sceneShare;
  tick->scene = felt.scene;
  tick->acted = felt.acted;
  tick->valid = felt.valid;
  tick->clutched = felt.clutched;
  tick->hold_time = felt.holdTime;
  copy(felt.deviceTorque, tick->device_torque);
  copy(felt.idealTorque, tick->ideal_torque);
  std::fill(std::begin(tick->reserved), std::end(tick->reserved), 0.0);
}

void palpate_stop(palpate_contact* contact)
{
  contact->servo.stop();
}

void palpate_start(palpate_contact* contact)
{
  contact->servo.start();
}

palpate_scene* palpate_scene_new(const palpate_body* body, const palpate_settings* settings,
  double force_factor, char* error, size_t error_size)
{
  try
  {
    return handleOf(makeScene(body, settings, force_factor, error, error_size));
  }
  catch (const std::exception& failure)
  {
    report(std::string("cannot make the scene: ") + failure.what(), error, error_size);
  }
  return nullptr;
}

void palpate_scene_free(palpate_scene* scene)
{
  sceneOf(scene).reset();
}

void palpate_change(palpate_contact* contact, palpate_scene* scene)
{
  contact->servo.change(sceneOf(scene));
}

palpate_scene* palpate_take_retired(palpate_contact* contact)
{
  return handleOf(contact->servo.takeRetired());
}
