package org.phrenic.scene.gl;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.SocketAddress;
import java.net.StandardProtocolFamily;
import java.net.UnixDomainSocketAddress;
import java.nio.channels.SocketChannel;
import java.nio.file.Files;
import java.nio.file.Path;
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
        try {
            int number = Integer.parseInt(display.substring(colon + 1).replaceAll("\\..*", ""));
            boolean here = host.isEmpty() || host.equals("unix");
            Path socket = Path.of("/tmp/.X11-unix/X" + number);
            if (here) {
                return Files.exists(socket) && connects(UnixDomainSocketAddress.of(socket));
            }
            return connects(new InetSocketAddress(host, FIRST_PORT + number));
        } catch (IOException | RuntimeException e) {
            return false;
        }
    }

    private static boolean connects(SocketAddress address) throws IOException {
        if (address instanceof UnixDomainSocketAddress) {
            try (SocketChannel channel = SocketChannel.open(StandardProtocolFamily.UNIX)) {
                return channel.connect(address);
            }
        }
        try (SocketChannel channel = SocketChannel.open()) {
            channel.socket().connect(address, TIMEOUT_MS);
            return true;
        }
    }
}
