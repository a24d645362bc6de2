package org.phrenic.cluster;

import java.util.List;
import java.util.function.Consumer;
import org.phrenic.study.sweep.RunRow;
import scala.runtime.AbstractFunction2;
import scala.runtime.BoxedUnit;

/** Hands the runs of a completed task on, in the driver. */
final class RowsHandler extends AbstractFunction2<Object, RunRow[], BoxedUnit> {
    private final Consumer<RunRow> done;

    RowsHandler(Consumer<RunRow> done) {
        this.done = done;
    }

    @Override
    public BoxedUnit apply(Object task, RunRow[] rows) {
        List.of(rows).forEach(done);
        return BoxedUnit.UNIT;
    }
}
