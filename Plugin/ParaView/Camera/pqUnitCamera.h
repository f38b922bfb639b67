// SPDX-License-Identifier: BSD-3-Clause
#ifndef pqUnitCamera_h
#define pqUnitCamera_h

#include <QHash>
#include <QObject>
#include <QSet>

class pqPipelineSource;

/**
 * A body whose Length Unit changes becomes ten or a thousand times as large, and a camera that
 * stays where it is shows nothing. Once such a change is applied, the render views that show the
 * body, or what is made of it, are reset; the direction they look in stays.
 *
 * Nothing else moves the camera: no other property, and no unit that comes with a state file.
 */
class pqUnitCamera : public QObject
{
  Q_OBJECT

public:
  explicit pqUnitCamera(QObject* parent = nullptr);
  ~pqUnitCamera() override;

  /// What ParaView's auto-start calls.
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

  QHash<pqPipelineSource*, int> Units; ///< in which each was last seen
  QSet<pqPipelineSource*> Waiting;     ///< for a view that shows what is in another one
};

#endif
