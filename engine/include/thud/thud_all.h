/* thud_all.h: includes every header of thud, for small programs. It only costs compile time:
 * functions that a program does not call are not linked. */
#ifndef THUD_ALL_H
#define THUD_ALL_H

#include "thud.h"
#include "thud_casts.h"
#include "thud_detection.h"
#include "thud_draw.h"
#include "thud_edits.h"
#include "thud_events.h"
#include "thud_fields.h"
#include "thud_forces.h"
#include "thud_hooks.h"
#include "thud_ids.h"
#include "thud_joint.h"
#include "thud_joint_at.h"
#include "thud_limits.h"
#include "thud_listeners.h"
#include "thud_lists.h"
#include "thud_locks.h"
#include "thud_make.h"
#include "thud_math.h"
#include "thud_minkowski.h"
#include "thud_mover.h"
#include "thud_quality.h"
#include "thud_queries.h"
#include "thud_reads.h"
#include "thud_result.h"
#include "thud_rollback.h"
#include "thud_rules.h"
#include "thud_geometry.h"
#include "thud_snapshot.h"
#include "thud_terrain.h"
#include "thud_testing.h"
#include "thud_version.h"
#include "thud_volumes.h"

#endif
