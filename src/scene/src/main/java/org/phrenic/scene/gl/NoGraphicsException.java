package org.phrenic.scene.gl;

/** No picture can be made here; the message is one sentence that says what is missing. */
public final class NoGraphicsException extends Exception {
    private static final long serialVersionUID = 1;

    public NoGraphicsException(String sentence) {
        super(sentence);
    }

    public NoGraphicsException(String sentence, Throwable cause) {
        super(sentence, cause);
    }
}
