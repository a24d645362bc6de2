package org.phrenic.simulation.live;

import java.util.List;
import org.phrenic.simulation.*;

public final class LiveRun implements AutoCloseable {
    public interface Listener { void loading(String what, double share); void ready(LiveScene scene); void failed(String sentence); void diverged(String sentence); void changed(); }
    private volatile Scenario scenario; private final Listener listener; private volatile boolean playing = true, closed; private volatile double speed = 1;
    private volatile Frame latest; private volatile Status status = new Status(0,0,0.001,1,0,0,false,"","");
    public LiveRun(Scenario first, Listener listener) { this.scenario = first; this.listener = listener; load(first); }
    private void go(Scenario s) {
        listener.loading("Building the thorax", 0.1);
        try (Simulation sim = Simulation.of(s, SimulationRun.thorax(s))) {
            listener.loading("Settling", 0.8);
            SceneSurfaces surfaces = new SceneSurfaces(sim);
            Frame f = surfaces.newFrame();
            latest = f; scenario = s;
            listener.ready(new LiveScene(s, surfaces.surfaces(), List.of(), surfaces::newFrame, sim.system().nodeCount(), 0, List.of(), 1));
            long begun = System.nanoTime();
            while (!closed && scenario == s) {
                if (!playing) { Thread.sleep(10); continue; }
                long t = System.nanoTime();
                for (int i = 0; i < 16; i++) sim.step();
                synchronized (this) { surfaces.capture(f); }
                double wait = 16 * s.timeStepS() / speed - (System.nanoTime() - t) * 1e-9;
                if (wait > 0) Thread.sleep((long) (wait * 1000));
                double d = (System.nanoTime() - t) * 1e-9;
                status = new Status(sim.stepper().steps(), sim.time(), s.timeStepS(), 1, 16 / d, 16 * s.timeStepS() / d, true, "", "inspiration");
            }
        } catch (InterruptedException e) { Thread.currentThread().interrupt(); } catch (RuntimeException e) { listener.failed(e.getMessage()); }
    }
    public void play() { playing = true; }
    public void pause() { playing = false; }
    public boolean isPlaying() { return playing; }
    public void stepOnce() {}
    public void reset() {}
    public void setSpeed(double factor) { speed = factor; }
    public void change(List<Assignment> list) { load(scenario.with(list)); }
    public void load(Scenario s) { Thread t = new Thread(() -> go(s)); t.setDaemon(true); t.start(); }
    public void cancelLoading() {}
    public void restoreLastGood() {}
    public Scenario scenario() { return scenario; }
    public String command() { return "phrenic run"; }
    public String commandHash() { return ""; }
    public Status status() { return status; }
    public synchronized boolean takeFrame(Frame into) { Frame l = latest; if (l == null || l.step() <= into.step()) return false; into.copyFrom(l); return true; }
    public History history() { return new History(); }
    @Override public void close() { closed = true; }
}
