/**
 * Execution of the runs of a study: on threads of this machine, in shards, or by another executor; the journal from
 * which a study resumes; the folder of its results.
 */
package org.phrenic.study.sweep.run;
