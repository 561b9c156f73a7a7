//! Hashes over lists of fields, plain or keyed with a secret.

use std::fmt;

use hmac::{Hmac, KeyInit, Mac};
use sha2::{Digest, Sha256};
use thiserror::Error;

/// The contents of a secret file, which keys the seeds of an exam.
///
/// Whoever has the bank and a sheet's code can draw the sheet again and read its key, unless the seeds
/// are keyed: then the secret is needed as well.
///
/// # Examples
///
/// ```
/// use vibank::seed::Secret;
/// assert!(Secret::new(b"correct horse battery staple").is_ok());
/// assert!(Secret::new(b"1234").is_err());
/// ```
#[derive(Clone)]
pub struct Secret(Vec<u8>);

/// Why a text cannot serve as a secret.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum SecretError {
    /// It could be found by trying.
    #[error(
        "a secret of {length} bytes can be guessed; at least {} are needed",
        Secret::MIN_LENGTH
    )]
    TooShort {
        /// Bytes besides the white space at both ends.
        length: usize,
    },
}

impl Secret {
    /// The fewest bytes that a secret may have.
    pub(crate) const MIN_LENGTH: usize = 16;

    /// The secret in these bytes; white space at both ends does not count.
    ///
    /// # Errors
    ///
    /// If fewer than `Secret::MIN_LENGTH` bytes are left.
    pub fn new(bytes: &[u8]) -> Result<Self, SecretError> {
        let bytes = bytes.trim_ascii();
        if bytes.len() < Self::MIN_LENGTH {
            return Err(SecretError::TooShort {
                length: bytes.len(),
            });
        }
        Ok(Self(bytes.to_vec()))
    }
}

impl fmt::Debug for Secret {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Secret(…)")
    }
}

/// One field of what is hashed.
#[derive(Clone, Copy)]
pub(crate) enum HashedField<'a> {
    Text(&'a str),
    Number(u64),
}

/// Feeds a field, preceded by its length, to a hash.
pub(crate) fn feed(field: HashedField<'_>, mut update: impl FnMut(&[u8])) {
    match field {
        HashedField::Text(text) => {
            update(&(text.len() as u64).to_be_bytes());
            update(text.as_bytes());
        }
        HashedField::Number(number) => {
            update(&8_u64.to_be_bytes());
            update(&number.to_be_bytes());
        }
    }
}

/// The first eight bytes of the hash of some fields, as a number; keyed if there is a secret.
pub(crate) fn derive(fields: &[HashedField<'_>], secret: Option<&Secret>) -> u64 {
    let hash: [u8; 32] = match secret {
        None => {
            let mut hash = Sha256::new();
            for &field in fields {
                feed(field, |bytes| hash.update(bytes));
            }
            hash.finalize().into()
        }
        Some(Secret(key)) => {
            let mut hash =
                <Hmac<Sha256>>::new_from_slice(key).expect("HMAC takes keys of any length");
            for &field in fields {
                feed(field, |bytes| hash.update(bytes));
            }
            hash.finalize().into_bytes().into()
        }
    };
    let mut head = [0; 8];
    head.copy_from_slice(&hash[..8]);
    u64::from_be_bytes(head)
}
