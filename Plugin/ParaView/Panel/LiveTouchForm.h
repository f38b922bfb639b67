// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_LiveTouchForm_h
#define palpate_LiveTouchForm_h

#include <QString>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QToolButton;
class QWidget;
class pqForceBar;
class pqOutputPort;

namespace palpate
{
struct LiveTouchSource;
class LiveTouchSession;

/// The widgets of the panel. For event scripts, the object name of each widget is the name of its
/// member. The panel defines the actions of the widgets.
struct LiveTouchForm
{
  explicit LiveTouchForm(QWidget* contents);

  QLabel* body; ///< name of the source in use, or a hint for the user
  /// Names of the responses; the data of an item is the prefix of the response arrays.
  QComboBox* response;
  /// Names of the devices; the data of an item is the address of a device that was found.
  QComboBox* device;
  QToolButton* find;     ///< starts a new search for devices
  QDoubleSpinBox* depth; ///< depth of the press, mm; 0 for half of the range
  QCheckBox* snap;    ///< whether the tip is first moved to the surface point nearest to the handle
  QPushButton* start; ///< Start, Cancel or Stop
  QLabel* state;      ///< such as "stick", "no contact" or "making the search structure …"
  QLabel* remark; ///< the error, or the reason why the applied force differs from the ideal force
  pqForceBar* bar;
  QLabel* force;      ///< applied force, N
  QLabel* limit;      ///< largest force of the device, N
  QLabel* error;      ///< relative error of the ideal force
  QLabel* memory;     ///< the memory part of the ideal force
  QLabel* deflection; ///< deflection, mm
  QLabel* servo;      ///< number of ticks per second and number of missed ticks
  QLabel* grant;      ///< scheduling that the system grants to the servo thread

  /// Lists "simulated", "plant" and the devices that are plugged in. The present text remains
  /// unchanged.
  void listDevices();
  QString chosenDevice() const;
  /// Shows the body and the responses of a source.
  void showSource(const LiveTouchSource& source, const QString& name);
  QString chosenResponse() const;
  /// Shows state, forces and rate of the running session. `rate` is the number of ticks per second;
  /// 0 while it is unknown.
  void showTouch(LiveTouchSession& touch, double rate);
  /// Shows that no session is running, and the reason `fault` if it is not "".
  void showRest(const LiveTouchSession& touch, bool canStart, const QString& fault);

private:
  /// The body whose responses are listed; used only for comparison.
  const pqOutputPort* shown = nullptr;
};
} // namespace palpate

#endif
