package org.phrenic.ui;

import java.util.Optional;
import org.phrenic.rehearsal.NeedleState;
import org.phrenic.rehearsal.PathAdvice;
import org.phrenic.rehearsal.PathCycle;
import org.phrenic.rehearsal.Rehearsal;
import org.phrenic.rehearsal.RehearsalPlan;
import org.phrenic.rehearsal.TargetStudy;

/** Where the needle is meant to go in, and what is to be said of that way over the breath and at this moment. On the event dispatch thread, but for {@link #level}. */
final class WayIn {
    private final Session session;
    private final RehearsalDoor door;
    private final Background work;
    private Optional<double[]> entry = Optional.empty();
    private volatile Optional<PathAdvice> advice = Optional.empty();

    WayIn(Session session, RehearsalDoor door, Background work) {
        this.session = session;
        this.door = door;
        this.work = work;
    }

    /** No way is chosen. */
    void forget() {
        entry = Optional.empty();
        advice = Optional.empty();
    }

    /** Means to go in at a place of the skin, given as it is at end-expiration. */
    void enterAt(double[] onSkinRest) {
        if (door.stage() != DoorStage.READY) {
            return;
        }
        if (door.state().filter(s -> s.placed() && s.depthMm() > 0).isPresent()) {
            session.say(Session.Message.Kind.NOTE, "Take the needle out first.");
            return;
        }
        entry = Optional.of(onSkinRest);
        door.hand().enterAt(onSkinRest);
        TargetStudy about = door.study().orElseThrow();
        RehearsalPlan plan = door.plan().orElseThrow();
        RehearsedBody body = door.body().orElseThrow();
        work.run(
                () -> PathCycle.of(
                        body.mapped(), about.map().cycle(), onSkinRest, about.target(), plan.needle(), plan.avoided()),
                found -> {
                    advice = Optional.of(PathAdvice.of(found));
                    door.tell();
                },
                sentence -> session.say(Session.Message.Kind.REFUSED, sentence));
    }

    /** The best entry of the map, over the breath or at its end. */
    void enterAtBest(boolean atEndExpiration) {
        if (door.stage() == DoorStage.READY) {
            TargetStudy study = door.study().orElseThrow();
            Optional<Integer> best = atEndExpiration
                    ? study.map().bestAt(0, Rehearsal.ROOM_MM)
                    : study.map().best(Rehearsal.ROOM_MM);
            if (best.isPresent()) {
                enterAt(study.map().pointAtRest(best.get()));
            } else {
                session.say(Session.Message.Kind.NOTE, "From nowhere on the skin is the way to this target free.");
            }
        }
    }

    Optional<double[]> entry() {
        return entry;
    }

    /** What is to be said of it; empty until it is worked out. */
    Optional<PathAdvice> advice() {
        return advice;
    }

    /** How the way is marked at this moment; on any thread. */
    PathAdvice.Level level(NeedleState state) {
        if (!state.reasons().isEmpty()) {
            return PathAdvice.Level.BARRED;
        }
        boolean close = state.marginMm() < Rehearsal.ROOM_MM;
        boolean partly = advice.filter(a -> a.level() != PathAdvice.Level.FREE).isPresent();
        return close || partly || !state.warnings().isEmpty() ? PathAdvice.Level.CAREFUL : PathAdvice.Level.FREE;
    }
}
