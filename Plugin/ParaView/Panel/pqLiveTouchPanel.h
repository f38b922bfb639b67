// SPDX-License-Identifier: BSD-3-Clause
#ifndef pqLiveTouchPanel_h
#define pqLiveTouchPanel_h

#include "LiveTouchForm.h"
#include "LiveTouchSession.h"
#include "LiveTouchStage.h"

#include <QDockWidget>
#include <QElapsedTimer>
#include <QTimer>

class pqOutputPort;
class pqPipelineSource;
class pqServer;
class pqView;

/**
 * The dock *Live Touch*, in which a haptic device touches the body of the active source. A servo
 * thread computes the force, and the active render view shows it.
 *
 * The panel connects widgets (LiveTouchForm), session (LiveTouchSession), pipeline
 * (LiveTouchSource) and view (LiveTouchStage). While a session runs, a timer reads the newest tick
 * about 60 times a second. The view is rendered when the tool has moved; at least half of the time
 * remains for the user's input. The panel waits neither for the servo thread nor for a preparation;
 * it waits only for data of a remote server.
 *
 * The session ends, and with it the force of the device, when the dock is closed, before its
 * source, view or server is removed, before a state is loaded, and when ParaView quits. Body, view
 * and handle of a session do not change after its Start, but new data of the body replace the old
 * data.
 */
class pqLiveTouchPanel : public QDockWidget
{
  Q_OBJECT

public:
  explicit pqLiveTouchPanel(QWidget* parent = nullptr);
  ~pqLiveTouchPanel() override;

private Q_SLOTS:
  void startOrStop();
  void stop();
  void onToggled(bool shown);
  void frame();
  void showSource();
  void takeBody();
  void onDataUpdated(pqPipelineSource* source);
  void onSourceGoes(pqPipelineSource* source);
  void onViewGoes(pqView* view);
  void onRenderBegins();
  void onRenderEnds();

protected:
  void showEvent(QShowEvent* event) override;
  void closeEvent(QCloseEvent* event) override;

private:
  void start();
  void fail(const QString& error);
  void onSessionChanged();
  palpate::TouchHandle readHandle() const;
  void showNumbers();
  bool isIdle() const { return this->Touch.state() == palpate::LiveTouchSession::State::Idle; }

  palpate::LiveTouchForm* Form; ///< owned by this object, together with the widgets of the form
  palpate::LiveTouchStage Stage;
  /// Declared after the stage, so that it is destroyed before the stage.
  palpate::LiveTouchSession Touch;
  pqOutputPort* Body = nullptr;       ///< the body in use; null while idle
  pqPipelineSource* Leader = nullptr; ///< the source whose handle defines the tip, or null
  bool CanStart = false;
  QString Fault; ///< error of the last start
  bool Fetching = false;
  QTimer Frame;
  QElapsedTimer Rendering; ///< time since the last rendering began
  QElapsedTimer Rest;      ///< time since the last rendering ended
  qint64 RenderTime = 0;   ///< duration of the last rendering, ms
  QElapsedTimer Shown;     ///< time since the last update of the numbers
  QElapsedTimer Measured;  ///< time since the last measurement of the tick rate
  vtkIdType MeasuredTicks = 0;
  double Rate = 0.0; ///< measured number of ticks per second
};

#endif
