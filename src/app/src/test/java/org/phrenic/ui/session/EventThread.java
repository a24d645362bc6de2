package org.phrenic.ui.session;

import java.lang.reflect.InvocationTargetException;
import java.util.concurrent.Callable;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.BooleanSupplier;
import javax.swing.SwingUtilities;

/** Tests on the event thread, where the window's classes are at home, and waits beside it. */
public final class EventThread {
    private static final long LONGEST_MS = 60_000;
    private static final long LOOK_MS = 20;

    private EventThread() {}

    public static <T> T get(Callable<T> what) {
        AtomicReference<T> result = new AtomicReference<>();
        try {
            SwingUtilities.invokeAndWait(() -> {
                try {
                    result.set(what.call());
                } catch (Exception e) {
                    throw new IllegalStateException(e);
                }
            });
        } catch (InvocationTargetException e) {
            throw new AssertionError(e.getCause());
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new AssertionError(e);
        }
        return result.get();
    }

    public static void run(Runnable what) {
        get(() -> {
            what.run();
            return null;
        });
    }

    /** Waits until something holds on the event thread. */
    public static void until(String what, BooleanSupplier holds) {
        long end = System.currentTimeMillis() + LONGEST_MS;
        while (!get(holds::getAsBoolean)) {
            if (System.currentTimeMillis() > end) {
                throw new AssertionError("waited in vain until " + what);
            }
            try {
                Thread.sleep(LOOK_MS);
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
                throw new AssertionError(e);
            }
        }
    }
}
