// SPDX-License-Identifier: BSD-3-Clause
#ifndef pqUnitCamera_h
#define pqUnitCamera_h

#include <QHash>
#include <QObject>
#include <QSet>

class pqPipelineSource;

/**
 * When the Length Unit of a body changes, the body becomes ten or a thousand times as large, and an
 * unchanged camera shows nothing. When the change is applied, this class resets the render views
 * that show the body or its results. The direction of the views does not change.
 *
 * No other property moves the camera, and neither does a unit that a state file sets.
 */
class pqUnitCamera : public QObject
{
  Q_OBJECT

public:
  explicit pqUnitCamera(QObject* parent = nullptr);
  ~pqUnitCamera() override;

  /// Called by ParaView's auto-start.
  void startup();
  void shutdown() {}

private Q_SLOTS:
  void watch(pqPipelineSource* source);
  void forget(pqPipelineSource* source);
  void onDataUpdated(pqPipelineSource* source);
  void resetViewsSoon();
  void resetViews();

private:
  Q_DISABLE_COPY(pqUnitCamera)

  QHash<pqPipelineSource*, int> Units; ///< the last Length Unit of each source
  QSet<pqPipelineSource*> Waiting;     ///< sources whose views must be reset
};

#endif
