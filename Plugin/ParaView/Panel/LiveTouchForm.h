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

/// The widgets of the panel, each with an object name of its own for event scripts: that of the
/// member. What they do is the panel's.
struct LiveTouchForm
{
  explicit LiveTouchForm(QWidget* contents);

  QLabel* body;          ///< name of the source that is touched, or what there is to do
  QComboBox* response;   ///< data: prefix of its arrays
  QComboBox* device;     ///< text or, of a device found, data: its address
  QToolButton* find;     ///< looks for devices again
  QDoubleSpinBox* depth; ///< mm; 0: half of the range
  QCheckBox* snap;       ///< whether the tip keeps to the surface under the handle
  QPushButton* start;    ///< Start, Cancel or Stop
  QLabel* state;         ///< "stick", "no contact", "making the search structure …"
  QLabel* remark;        ///< what is wrong, and why the force applied is not the ideal one
  pqForceBar* bar;
  QLabel* force;      ///< N, applied
  QLabel* limit;      ///< N
  QLabel* error;      ///< of the ideal force, relative
  QLabel* memory;     ///< what of the ideal force a body that relaxes adds
  QLabel* deflection; ///< mm
  QLabel* servo;      ///< ticks per second, and missed
  QLabel* grant;      ///< what the system granted the servo thread

  /// "simulated", "plant", and what is plugged in; the text that was there stays.
  void listDevices();
  QString chosenDevice() const;
  /// Body and responses of a source.
  void showSource(const LiveTouchSource& source, const QString& name);
  QString chosenResponse() const;
  /// State, forces, rate of what runs. `rate` in ticks per second, 0 while it
  /// is not known.
  void showTouch(LiveTouchSession& touch, double rate);
  /// That nothing runs, or not yet; and why, or "".
  void showRest(const LiveTouchSession& touch, bool canStart, const QString& fault);
};
} // namespace palpate

#endif
