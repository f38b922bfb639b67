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

namespace palpate
{
struct LiveTouchSource;
class LiveTouchSession;

/// The widgets of the panel, each with its member's name as object name, for event scripts. The
/// panel defines what they do.
struct LiveTouchForm
{
  explicit LiveTouchForm(QWidget* contents);

  QLabel* body;          ///< name of the source that is touched, or what to do
  QComboBox* response;   ///< data: prefix of its arrays
  QComboBox* device;     ///< text, or for a device found, data: its address
  QToolButton* find;     ///< searches for devices again
  QDoubleSpinBox* depth; ///< mm; 0: half of the range
  QCheckBox* snap;       ///< whether the tip keeps to the surface under the handle
  QPushButton* start;    ///< Start, Cancel or Stop
  QLabel* state;         ///< "stick", "no contact", "making the search structure …"
  QLabel* remark;        ///< what is wrong, or why the applied force is not the ideal one
  pqForceBar* bar;
  QLabel* force;      ///< N, applied
  QLabel* limit;      ///< N
  QLabel* error;      ///< of the ideal force, relative
  QLabel* memory;     ///< the memory part of the ideal force
  QLabel* deflection; ///< mm
  QLabel* servo;      ///< ticks per second, and missed
  QLabel* grant;      ///< what the system granted the servo thread

  /// Lists "simulated", "plant", and the devices that are plugged in; keeps the present text.
  void listDevices();
  QString chosenDevice() const;
  /// Body and responses of a source.
  void showSource(const LiveTouchSource& source, const QString& name);
  QString chosenResponse() const;
  /// State, forces and rate of the running session. `rate` in ticks per second, 0 while it is not
  /// known.
  void showTouch(LiveTouchSession& touch, double rate);
  /// Shows that nothing runs, or not yet; and why, or "".
  void showRest(const LiveTouchSession& touch, bool canStart, const QString& fault);
};
} // namespace palpate

#endif
