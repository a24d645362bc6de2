package org.phrenic.cluster;

import java.io.Serializable;
import java.util.ArrayList;
import java.util.List;
import org.phrenic.study.sweep.RunRow;
import org.phrenic.study.sweep.SweepPlan;
import scala.collection.Iterator;
import scala.runtime.AbstractFunction1;

/** A task: the runs with given indices of a study, which travels as its text. */
final class RunTask extends AbstractFunction1<Iterator<Integer>, RunRow[]> implements Serializable {
    private static final long serialVersionUID = 1;

    private final String study;

    /** @param study resolved text of the study */
    RunTask(String study) {
        this.study = study;
    }

    @Override
    public RunRow[] apply(Iterator<Integer> indices) {
        SweepPlan plan = ExecutorPlans.of(study);
        List<RunRow> rows = new ArrayList<>();
        while (indices.hasNext()) {
            rows.add(RunRow.of(plan.model(), plan.points().get(indices.next())));
        }
        return rows.toArray(RunRow[]::new);
    }
}
