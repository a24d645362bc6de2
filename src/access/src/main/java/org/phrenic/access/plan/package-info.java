/** Rehearsal plans: their steps and goals, how they are played headless or live, and their reports. */
package org.phrenic.access.plan;
