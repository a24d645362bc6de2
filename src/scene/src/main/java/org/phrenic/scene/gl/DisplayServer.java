package org.phrenic.scene.gl;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.StandardProtocolFamily;
import java.net.UnixDomainSocketAddress;
import java.nio.channels.SocketChannel;
import java.util.Locale;

/**
 * Tests whether an X server is reachable. Must run before JOGL is loaded, because JOGL chooses the window system once
 * per process.
 */
final class DisplayServer {
    private static final int FIRST_PORT = 6000;
    private static final int TIMEOUT_MS = 2000;

    private DisplayServer() {}

    /** Whether this platform (macOS, Windows) needs no X server. */
    static boolean isNotNeeded() {
        String os = System.getProperty("os.name").toLowerCase(Locale.ROOT);
        return os.contains("mac") || os.contains("win");
    }

    /**
     * Whether the server that the variable DISPLAY names accepts a connection.
     *
     * @param display value of DISPLAY, such as {@code :0} or {@code localhost:10.0}; null or empty for none
     */
    static boolean isReachable(String display) {
        if (display == null || display.lastIndexOf(':') < 0) {
            return false;
        }
        int colon = display.lastIndexOf(':');
        String host = display.substring(0, colon);
        boolean here = host.isEmpty() || host.equals("unix");
        try (SocketChannel channel = here ? SocketChannel.open(StandardProtocolFamily.UNIX) : SocketChannel.open()) {
            int number = Integer.parseInt(display.substring(colon + 1).replaceAll("\\..*", ""));
            if (here) {
                return channel.connect(UnixDomainSocketAddress.of("/tmp/.X11-unix/X" + number));
            }
            channel.socket().connect(new InetSocketAddress(host, FIRST_PORT + number), TIMEOUT_MS);
            return true;
        } catch (IOException | RuntimeException e) {
            return false;
        }
    }
}
