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

/// The widgets of the panel. The object name of each is the name of its member, for event scripts.
/// The panel defines their actions.
struct LiveTouchForm
{
  explicit LiveTouchForm(QWidget* contents);

  QLabel* body;          ///< name of the source in use, or a hint for the user
  QComboBox* response;   ///< names of the responses; data: prefix of the response arrays
  QComboBox* device;     ///< text: the device; data: the address of a device that was found
  QToolButton* find;     ///< starts another search for devices
  QDoubleSpinBox* depth; ///< depth of the press, mm; 0: half of the range
  QCheckBox* snap;    ///< whether the tip is first moved to the surface point nearest to the handle
  QPushButton* start; ///< Start, Cancel or Stop
  QLabel* state;      ///< "stick", "no contact", "making the search structure …"
  QLabel* remark;     ///< the error, or the reason why the applied force differs from the ideal
                      ///< one
  pqForceBar* bar;
  QLabel* force;      ///< applied force, N
  QLabel* limit;      ///< N
  QLabel* error;      ///< relative error of the ideal force
  QLabel* memory;     ///< the memory part of the ideal force
  QLabel* deflection; ///< mm
  QLabel* servo;      ///< ticks per second, and missed ticks
  QLabel* grant;      ///< scheduling that the system permits the servo thread

  /// Lists "simulated", "plant", and the devices that are plugged in. The present text is kept.
  void listDevices();
  QString chosenDevice() const;
  /// Shows the body and the responses of a source.
  void showSource(const LiveTouchSource& source, const QString& name);
  QString chosenResponse() const;
  /// Shows state, forces and rate of the running session. `rate`: ticks per second, 0 while it is
  /// unknown.
  void showTouch(LiveTouchSession& touch, double rate);
  /// Shows that no session runs (yet), and the reason `fault`, if it is not "".
  void showRest(const LiveTouchSession& touch, bool canStart, const QString& fault);

private:
  const pqOutputPort* shown = nullptr; ///< the body whose responses are listed; only compared
};
} // namespace palpate

#endif
