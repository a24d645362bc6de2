/** Rehearsal plans, their steps and goals, live rehearsals and reports. */
package org.phrenic.access.plan;
