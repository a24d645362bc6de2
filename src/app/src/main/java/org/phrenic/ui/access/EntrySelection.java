package org.phrenic.ui.access;

import java.util.Optional;
import org.phrenic.access.path.PathOverBreath;
import org.phrenic.access.path.TargetAccess;
import org.phrenic.access.plan.NeedleState;
import org.phrenic.access.plan.PathAdvice;
import org.phrenic.access.plan.Rehearsal;
import org.phrenic.access.plan.RehearsalPlan;
import org.phrenic.ui.session.BackgroundWorker;
import org.phrenic.ui.session.Session;

/**
 * Where the needle is meant to go in, and what is to be said of that way over the breath and at this moment. On the
 * event dispatch thread, but for {@link #levelNow}.
 */
public final class EntrySelection {
    private final Session session;
    private final RehearsalController rehearsal;
    private final BackgroundWorker work;
    private Optional<double[]> entry = Optional.empty();
    private volatile Optional<PathAdvice> advice = Optional.empty();

    EntrySelection(Session session, RehearsalController rehearsal, BackgroundWorker work) {
        this.session = session;
        this.rehearsal = rehearsal;
        this.work = work;
    }

    /** No way is chosen. */
    void clear() {
        entry = Optional.empty();
        advice = Optional.empty();
    }

    /** Means to go in at a place of the skin, given as it is at end-expiration. */
    public void select(double[] onSkinRest) {
        if (rehearsal.stage() != RehearsalStage.READY) {
            return;
        }
        if (rehearsal.state().filter(s -> s.placed() && s.depthMm() > 0).isPresent()) {
            session.note("Take the needle out first.");
            return;
        }
        entry = Optional.of(onSkinRest);
        rehearsal.needle().setEntry(onSkinRest);
        TargetAccess about = rehearsal.study().orElseThrow();
        RehearsalPlan plan = rehearsal.plan().orElseThrow();
        RehearsalBody body = rehearsal.body().orElseThrow();
        work.run(
                () -> PathOverBreath.of(
                        body.planningScene(),
                        about.map().cycle(),
                        onSkinRest,
                        about.target(),
                        plan.needle(),
                        plan.avoided()),
                found -> {
                    advice = Optional.of(PathAdvice.of(found));
                    rehearsal.fireState();
                },
                session::refuse);
    }

    /** The best entry of the map, over the breath or at its end. */
    public void selectBest(boolean atEndExpiration) {
        if (rehearsal.stage() == RehearsalStage.READY) {
            TargetAccess study = rehearsal.study().orElseThrow();
            Optional<Integer> best = atEndExpiration
                    ? study.map().bestAt(0, Rehearsal.SUFFICIENT_MARGIN_MM)
                    : study.map().best(Rehearsal.SUFFICIENT_MARGIN_MM);
            if (best.isPresent()) {
                select(study.map().pointAtRest(best.get()));
            } else {
                session.note("From nowhere on the skin is the way to this target free.");
            }
        }
    }

    public Optional<double[]> entry() {
        return entry;
    }

    /** What is to be said of it; empty until it is worked out. */
    public Optional<PathAdvice> advice() {
        return advice;
    }

    /** How the way is marked at this moment; on any thread. */
    public PathAdvice.Level levelNow(NeedleState state) {
        if (!state.reasons().isEmpty()) {
            return PathAdvice.Level.BARRED;
        }
        boolean close = state.marginMm() < Rehearsal.SUFFICIENT_MARGIN_MM;
        boolean partly = advice.filter(a -> a.level() != PathAdvice.Level.FREE).isPresent();
        return close || partly || !state.warnings().isEmpty() ? PathAdvice.Level.CAREFUL : PathAdvice.Level.FREE;
    }
}
