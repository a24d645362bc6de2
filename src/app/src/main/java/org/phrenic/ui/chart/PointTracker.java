package org.phrenic.ui.chart;

import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.phrenic.simulation.live.LiveScene;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Surface;
import org.phrenic.ui.session.Session;

/** Tracks the displacement of picked vertices, up positive, since they were picked. */
final class PointTracker {
    private record Track(PlotCurve curve, int surface, int vertex, double startHeightMm) {}

    private final Session session;
    private final Track[] tracks = new Track[PlotCurve.MAX_POINTS];
    private LiveScene scene;
    private Frame frame;
    private int nextSlot;

    PointTracker(Session session) {
        this.session = session;
    }

    /** Takes over a scene; points of the scene before are dropped. */
    void reset(LiveScene newScene) {
        scene = newScene;
        frame = null;
        Arrays.fill(tracks, null);
        nextSlot = 0;
    }

    /** Tracks a vertex; empty while there is no scene. */
    Optional<PlotCurve> track(int surface, int vertex) {
        if (scene == null) {
            return Optional.empty();
        }
        if (frame == null) {
            frame = scene.newFrame().get();
        }
        session.live().copyNewestFrame(frame);
        int slot = nextSlot;
        nextSlot = (nextSlot + 1) % tracks.length;
        Surface picked = scene.surfaces().get(surface);
        PlotCurve curve = PlotCurve.ofPoint(slot);
        tracks[slot] = new Track(curve, surface, vertex, heightMm(picked, surface, vertex));
        return Optional.of(curve);
    }

    List<PlotCurve> curves() {
        return Arrays.stream(tracks).filter(Objects::nonNull).map(Track::curve).toList();
    }

    /** Records the present displacements. */
    void record(SampleRingBuffer ring) {
        if (frame == null || ring.size() == 0 || !session.live().copyNewestFrame(frame)) {
            return;
        }
        int sample = ring.nearest(frame.timeS());
        for (Track track : tracks) {
            if (track != null) {
                double heightMm = heightMm(scene.surfaces().get(track.surface), track.surface, track.vertex);
                ring.set(track.curve.index(), sample, heightMm - track.startHeightMm);
            }
        }
    }

    /** Height of a vertex in the frame, mm. */
    private double heightMm(Surface surface, int index, int vertex) {
        double[] rest = surface.rest().positions();
        return switch (surface.motion()) {
            case STILL -> rest[3 * vertex + 2];
            case DEFORMING -> frame.positions(index)[3 * vertex + 2];
            case RIGID -> {
                float[] r = frame.pose(index);
                yield r[8] * rest[3 * vertex] + r[9] * rest[3 * vertex + 1] + r[10] * rest[3 * vertex + 2] + r[11];
            }
        };
    }
}
