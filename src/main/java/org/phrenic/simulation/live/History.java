package org.phrenic.simulation.live;

import org.phrenic.simulation.Frame;

public final class History {
    public int size() { return 0; }
    public double time(int i) { return 0; }
    public double[] values(int i) { return new double[0]; }
    public int frames() { return 0; }
    public boolean frame(int i, Frame into) { return false; }
}
