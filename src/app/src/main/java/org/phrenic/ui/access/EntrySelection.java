package org.phrenic.ui.access;

import java.util.Optional;
import java.util.concurrent.Callable;
import org.phrenic.access.attempt.NeedleAngles;
import org.phrenic.access.path.AccessMap;
import org.phrenic.access.path.PathOverBreath;
import org.phrenic.access.path.SkinEntries;
import org.phrenic.access.path.TargetAccess;
import org.phrenic.access.plan.NeedleState;
import org.phrenic.access.plan.PathAdvice;
import org.phrenic.access.plan.RehearsalPlan;
import org.phrenic.access.ultrasound.ProbePose;
import org.phrenic.file.BadInputException;
import org.phrenic.ui.session.BackgroundWorker;
import org.phrenic.ui.session.Session;

/** The entry of the needle, and advice on its path. Used on the event dispatch thread, except {@link #levelNow}. */
public final class EntrySelection {
    private final Session session;
    private final RehearsalController rehearsal;
    private final BackgroundWorker work;
    private volatile Optional<Entry> entry = Optional.empty();
    private volatile Optional<PathAdvice> advice = Optional.empty();
    private boolean unknown;

    /**
     * An entry of the needle.
     *
     * @param restMm place on the skin at end-expiration, LPS, mm
     * @param angles of a needle that has been put there
     */
    record Entry(double[] restMm, NeedleAngles angles) {}

    EntrySelection(Session session, RehearsalController rehearsal, BackgroundWorker work) {
        this.session = session;
        this.rehearsal = rehearsal;
        this.work = work;
    }

    void clear() {
        entry = Optional.empty();
        advice = Optional.empty();
    }

    /** Selects a place of the skin, given at end-expiration; the needle stands upright on it. */
    public void select(double[] onSkinRest) {
        select(onSkinRest, Optional.empty());
    }

    /**
     * Selects a place of the skin, given at end-expiration, with the needle at some angles, else upright. A place that
     * no needle may enter is refused, and the entry stays.
     */
    void select(double[] onSkinRest, Optional<NeedleAngles> angles) {
        if (rehearsal.stage() != RehearsalStage.READY || isRefused(onSkinRest)) {
            return;
        }
        rehearsal.attempt.takeOver();
        boolean placed = rehearsal.state().filter(NeedleState::placed).isPresent();
        if (placed || rehearsal.needle().awaitsMoves()) {
            session.note("Take the needle out first.");
            return;
        }
        RehearsalBody body = rehearsal.body.orElseThrow();
        Entry chosen = new Entry(
                onSkinRest,
                angles.orElseGet(() -> NeedleAngles.of(body.skin()
                        .at(onSkinRest)
                        .pose(body.frame(), ProbePose.Angles.ZERO)
                        .axial())));
        entry = Optional.of(chosen);
        advice = Optional.empty();
        unknown = false;
        rehearsal.needle().setEntry(chosen);
        TargetAccess about = rehearsal.study().orElseThrow();
        RehearsalPlan plan = rehearsal.plan().orElseThrow();
        Callable<PathOverBreath> analysis = () -> PathOverBreath.of(
                body.planningScene(), about.map().cycle(), onSkinRest, about.target(), plan.needle(), plan.avoided());
        // The advice is on the entry, whatever becomes of the attempt.
        work.runAlways(
                analysis,
                found -> ifStillChosen(chosen, () -> advice = Optional.of(PathAdvice.of(found, body.surfaces()))),
                sentence -> ifStillChosen(chosen, () -> {
                    unknown = true;
                    session.refuse(sentence);
                }));
        rehearsal.fireState();
    }

    /** Whether no needle may enter at a place of the skin, given at end-expiration; the reason is then shown. */
    private boolean isRefused(double[] onSkinRest) {
        try {
            SkinEntries.pointAtRest(rehearsal.body.orElseThrow().planningScene(), onSkinRest);
            return false;
        } catch (BadInputException bad) {
            session.refuse(bad.getMessage());
            return true;
        }
    }

    private void ifStillChosen(Entry which, Runnable then) {
        if (rehearsal.isActive() && entry.filter(which::equals).isPresent()) {
            then.run();
            rehearsal.fireState();
        }
    }

    /** Selects the best entry of the map: over the breath, or at end-expiration. */
    public void selectBest(boolean atEndExpiration) {
        if (rehearsal.stage() == RehearsalStage.READY) {
            AccessMap map = rehearsal.study().orElseThrow().map();
            double margin = AccessMap.SUFFICIENT_MARGIN_MM;
            (atEndExpiration ? map.bestAt(0, margin) : map.best(margin))
                    .ifPresentOrElse(
                            vertex -> select(map.pointAtRest(vertex)),
                            () -> session.note("No place on the skin has a free path to this target"
                                    + (atEndExpiration ? " at end-expiration." : ".")));
        }
    }

    public Optional<double[]> entry() {
        return entry.map(Entry::restMm);
    }

    /** The entry, with the angles of a needle that is put there. */
    Optional<Entry> chosen() {
        return entry;
    }

    /** Advice on the path over the breath; empty until it is computed. */
    public Optional<PathAdvice> advice() {
        return advice;
    }

    /** Why there is no advice on the path over the breath from the entry; empty if there is, or no entry. */
    public Optional<String> unadvised() {
        return entry.filter(e -> advice.isEmpty())
                .map(e -> unknown
                        ? "The path over the breath could not be computed"
                        : "Computing the path over the breath");
    }

    /** How the path is marked at present; on any thread. */
    public PathAdvice.Level levelNow(NeedleState state) {
        PathAdvice.Level present = presentLevel(state);
        boolean free = entry.isEmpty()
                || advice.filter(a -> a.level() == PathAdvice.Level.FREE).isPresent();
        return present == PathAdvice.Level.FREE && !free ? PathAdvice.Level.CAREFUL : present;
    }

    /** What is to be said of the path at one moment, whatever comes later in the breath. */
    public static PathAdvice.Level presentLevel(NeedleState state) {
        if (!state.reasons().isEmpty()) {
            return PathAdvice.Level.BARRED;
        }
        boolean close = state.marginMm() < AccessMap.SUFFICIENT_MARGIN_MM;
        return close || !state.warnings().isEmpty() ? PathAdvice.Level.CAREFUL : PathAdvice.Level.FREE;
    }
}
