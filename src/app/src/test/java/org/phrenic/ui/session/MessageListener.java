package org.phrenic.ui.session;

import java.util.function.Consumer;

/**
 * Hears what a session tells its user.
 *
 * @param heard receives the text of each message
 */
public record MessageListener(Consumer<String> heard) implements Session.Listener {
    @Override
    public void onMessage(SessionMessage message) {
        heard.accept(message.text());
    }
}
