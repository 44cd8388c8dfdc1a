package wbv.proof;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.security.GeneralSecurityException;
import java.security.MessageDigest;
import java.util.Arrays;
import java.util.Base64;
import java.util.HexFormat;
import java.util.zip.GZIPInputStream;
import java.util.zip.GZIPOutputStream;
import javax.crypto.Cipher;
import javax.crypto.SecretKey;
import javax.crypto.SecretKeyFactory;
import javax.crypto.spec.GCMParameterSpec;
import javax.crypto.spec.PBEKeySpec;
import javax.crypto.spec.SecretKeySpec;

/** Seals keys so that nobody reads one by accident: AES-256-GCM under a password (PBKDF2), as Base64 text. */
public final class Vault {

    private static final int ROUNDS = 20_000;
    private static final int NONCE = 12;
    private static final int TAG_BITS = 128;
    private static final byte[] SALT = "wbv concealed recordings".getBytes(StandardCharsets.UTF_8);

    private final SecretKey secret;

    /** Makes the key of the password, which takes a while by intent. */
    public Vault(String password) {
        try {
            byte[] raw = SecretKeyFactory.getInstance("PBKDF2WithHmacSHA256")
                    .generateSecret(new PBEKeySpec(password.toCharArray(), SALT, ROUNDS, 256)).getEncoded();
            secret = new SecretKeySpec(raw, "AES");
        } catch (GeneralSecurityException e) {
            throw new IllegalStateException("every Java has PBKDF2WithHmacSHA256", e);
        }
    }

    /** The text, sealed. The nonce follows from the text, so the same text seals to the same. */
    public String seal(String text) {
        return seal(text.getBytes(StandardCharsets.UTF_8));
    }

    private String seal(byte[] plain) {
        byte[] nonce = Arrays.copyOf(digest(plain), NONCE);
        byte[] hidden = cipher(Cipher.ENCRYPT_MODE, nonce, plain, 0, plain.length);
        byte[] all = Arrays.copyOf(nonce, NONCE + hidden.length);
        System.arraycopy(hidden, 0, all, NONCE, hidden.length);
        return Base64.getMimeEncoder(100, new byte[] {'\n'}).encodeToString(all) + "\n";
    }

    /**
     * What was sealed.
     *
     * @throws IllegalArgumentException if it was sealed under another password, or has been changed
     */
    public String open(String sealed) {
        return new String(opened(sealed), StandardCharsets.UTF_8);
    }

    /** A long text, packed before it is sealed. */
    String sealPacked(String text) {
        ByteArrayOutputStream packed = new ByteArrayOutputStream();
        try (GZIPOutputStream out = new GZIPOutputStream(packed)) {
            out.write(text.getBytes(StandardCharsets.UTF_8));
        } catch (IOException e) {
            throw new UncheckedIOException("memory takes every byte", e);
        }
        return seal(packed.toByteArray());
    }

    /** @throws IllegalArgumentException as {@link #open} does, or if it was not packed */
    String openPacked(String sealed) {
        try (GZIPInputStream in = new GZIPInputStream(new ByteArrayInputStream(opened(sealed)))) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw new IllegalArgumentException("is not packed", e);
        }
    }

    private byte[] opened(String sealed) {
        byte[] all = Base64.getMimeDecoder().decode(sealed);
        if (all.length < NONCE + TAG_BITS / 8) {
            throw new IllegalArgumentException("is cut short: a sealed key has more letters");
        }
        return cipher(Cipher.DECRYPT_MODE, Arrays.copyOf(all, NONCE), all, NONCE, all.length - NONCE);
    }

    /** SHA-256 in lower-case hex. */
    public static String sha256(String text) {
        return HexFormat.of().formatHex(digest(text.getBytes(StandardCharsets.UTF_8)));
    }

    private byte[] cipher(int mode, byte[] nonce, byte[] in, int from, int length) {
        try {
            Cipher cipher = Cipher.getInstance("AES/GCM/NoPadding");
            cipher.init(mode, secret, new GCMParameterSpec(TAG_BITS, nonce));
            return cipher.doFinal(in, from, length);
        } catch (GeneralSecurityException e) {
            throw new IllegalArgumentException("the key was sealed under another password, or has been changed", e);
        }
    }

    private static byte[] digest(byte[] in) {
        try {
            return MessageDigest.getInstance("SHA-256").digest(in);
        } catch (GeneralSecurityException e) {
            throw new IllegalStateException("every Java has SHA-256", e);
        }
    }
}
