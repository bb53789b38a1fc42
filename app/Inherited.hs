{-# LANGUAGE CApiFFI #-}

-- |
-- Module      : Inherited
-- Description : What the program has from whoever starts it
--
-- Standard streams may be closed, and signals may be ignored. Both are looked at in C, in the header @inherited.h@
-- beside this module; GHC compiles it into the module for the sake of the function that is imported from it, so that
-- the program has it however it is built. To be linked is enough for the streams: one that is closed is
-- @\/dev\/null@ before @main@ begins.
module Inherited
  ( isIgnored,
  )
where

import Foreign.C.Types (CInt (..))
import System.Posix.Signals (Signal)

foreign import capi unsafe "inherited.h dioptre_ignores" ignores :: CInt -> IO CInt

-- | Whether a signal is ignored, by the wish of whoever started the program.
isIgnored :: Signal -> IO Bool
isIgnored = fmap (/= 0) . ignores
