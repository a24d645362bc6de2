/** Rehearsal plans: steps and goals, live and headless playback, and reports. */
package org.phrenic.access.plan;
